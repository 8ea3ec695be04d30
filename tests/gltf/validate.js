// node validate.js NODE_MODULES FILE.glb...: what the Khronos validator says of each file, as a list in JSON.
const fs = require("fs");
const validator = require(`${process.argv[2]}/gltf-validator`);

Promise.all(process.argv.slice(3).map((file) => validator.validateBytes(new Uint8Array(fs.readFileSync(file)))))
  .then((reports) => console.log(JSON.stringify(reports.map((report) => report.issues))));
