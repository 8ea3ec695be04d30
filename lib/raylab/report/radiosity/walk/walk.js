// A walk through a solved scene. The light is known at every vertex, so a frame is one draw call: nothing is lit again.
{
  const solution = JSON.parse(document.getElementById("solution").textContent);
  const canvas = document.querySelector("canvas");

  // Numbers as the program wrote them: little-endian, base64.
  const numbers = (text, Kind) => new Kind(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);
  const vertices = numbers(solution.vertices, Float32Array), atVertices = numbers(solution.atVertices, Float32Array);
  const corners = numbers(solution.corners, Uint32Array), ofPatches = numbers(solution.ofPatches, Float32Array);
  const none = 0xffffffff;  // the fourth corner of a triangle

  // Two triangles for a quadrilateral, by its corners' places in a list of four.
  function triangles(patch, take) {
    for (const corner of corners[4 * patch + 3] === none ? [0, 1, 2] : [0, 1, 2, 0, 2, 3]) take(4 * patch + corner);
  }

  // Interpolated: vertices are shared.
  function smoothGeometry() {
    const index = [];
    for (let patch = 0; patch < corners.length / 4; ++patch) triangles(patch, (place) => index.push(corners[place]));
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(index), 1));
    geometry.setAttribute("position", new THREE.BufferAttribute(vertices, 3));
    geometry.setAttribute("radiance", new THREE.BufferAttribute(atVertices, 3));
    return geometry;
  }

  // Each patch in its own radiance: its corners are its own.
  function patchGeometry() {
    const places = [], radiance = [];
    for (let patch = 0; patch < corners.length / 4; ++patch)
      triangles(patch, (place) => {
        for (let axis = 0; axis < 3; ++axis) {
          places.push(vertices[3 * corners[place] + axis]);
          radiance.push(ofPatches[3 * patch + axis]);
        }
      });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(places), 3));
    geometry.setAttribute("radiance", new THREE.BufferAttribute(new Float32Array(radiance), 3));
    return geometry;
  }

  function sides() {
    const ends = [];
    for (let patch = 0; patch < corners.length / 4; ++patch) {
      const count = corners[4 * patch + 3] === none ? 3 : 4;
      for (let i = 0; i < count; ++i)
        for (const corner of [corners[4 * patch + i], corners[4 * patch + (i + 1) % count]])
          ends.push(vertices[3 * corner], vertices[3 * corner + 1], vertices[3 * corner + 2]);
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(ends), 3));
    return geometry;
  }

  // Radiance times the exposure, as an sRGB screen wants it.
  const exposure = { value: solution.exposure };
  const light = new THREE.ShaderMaterial({
    uniforms: { exposure },
    vertexShader: `
      attribute vec3 radiance;
      varying vec3 seen;
      void main() {
        seen = radiance;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      uniform float exposure;
      varying vec3 seen;
      void main() {
        vec3 linear = clamp(seen * exposure, 0.0, 1.0);
        vec3 low = 12.92 * linear, high = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
        gl_FragColor = vec4(mix(low, high, step(vec3(0.0031308), linear)), 1.0);
      }`,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,  // behind the lines of the mesh
  });

  function start() {
    const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    renderer.setClearColor(0x16171a);
    const scene = new THREE.Scene();
    const smooth = new THREE.Mesh(smoothGeometry(), light), patches = new THREE.Mesh(patchGeometry(), light);
    const lines = new THREE.LineSegments(sides(), new THREE.LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.45 }));
    patches.visible = lines.visible = false;
    scene.add(smooth, patches, lines);
    smooth.geometry.computeBoundingSphere();
    const size = smooth.geometry.boundingSphere.radius;
    const camera = new THREE.PerspectiveCamera(solution.camera.fov_y, 1, size / 1000, 20 * size);

    // The direction of view by two angles around the camera's own upward direction.
    const up = new THREE.Vector3(...solution.camera.up).normalize();
    const toTarget = new THREE.Vector3(...solution.camera.target).sub(new THREE.Vector3(...solution.camera.position)).normalize();
    const ahead = toTarget.clone().addScaledVector(up, -toTarget.dot(up)).normalize();
    const left = new THREE.Vector3().crossVectors(up, ahead);
    camera.up.copy(up);
    const view = {};
    const reset = () => {
      camera.position.set(...solution.camera.position);
      view.heading = 0;
      view.pitch = Math.asin(Math.max(-1, Math.min(1, toTarget.dot(up))));
    };
    const direction = () => new THREE.Vector3()
      .addScaledVector(ahead, Math.cos(view.pitch) * Math.cos(view.heading))
      .addScaledVector(left, Math.cos(view.pitch) * Math.sin(view.heading))
      .addScaledVector(up, Math.sin(view.pitch));
    const turn = (heading, pitch) => {
      view.heading += heading;
      view.pitch = Math.max(-1.5, Math.min(1.5, view.pitch + pitch));
    };
    const sideways = () => new THREE.Vector3().crossVectors(direction(), up).normalize();

    // Frames are drawn while something changes: a key is held, or another one asked for a frame.
    const held = new Set();
    const measured = { frames: 0, script: [] };  // milliseconds of the last frames
    let before = 0, asked = false;
    const ask = () => {
      if (!asked) requestAnimationFrame(frame);
      asked = true;
    };
    const steps = {
      KeyW: (way) => camera.position.addScaledVector(direction(), way), ArrowUp: (way) => camera.position.addScaledVector(direction(), way),
      KeyS: (way) => camera.position.addScaledVector(direction(), -way), ArrowDown: (way) => camera.position.addScaledVector(direction(), -way),
      KeyA: (way) => camera.position.addScaledVector(sideways(), -way), KeyD: (way) => camera.position.addScaledVector(sideways(), way),
      KeyE: (way) => camera.position.addScaledVector(up, way), KeyQ: (way) => camera.position.addScaledVector(up, -way),
      ArrowLeft: (way, seconds) => turn(1.2 * seconds, 0), ArrowRight: (way, seconds) => turn(-1.2 * seconds, 0),
    };
    function frame(now) {
      asked = false;
      const begun = performance.now(), seconds = Math.min(0.1, (now - before) / 1000);
      before = now;
      for (const key of held) steps[key](0.4 * size * seconds, seconds);
      camera.lookAt(camera.position.clone().add(direction()));
      renderer.render(scene, camera);
      measured.frames += 1;
      measured.script.push(performance.now() - begun);
      if (measured.script.length > 100) measured.script.shift();
      if (held.size > 0) ask();
    }
    function fit() {
      renderer.setPixelRatio(window.devicePixelRatio);
      renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
      camera.aspect = canvas.clientWidth / canvas.clientHeight;
      camera.updateProjectionMatrix();
      ask();
    }

    const slider = document.getElementById("exposure"), shown = document.querySelector("output");
    const expose = () => {
      exposure.value = solution.exposure * 2 ** Number(slider.value);
      shown.textContent = `${Number(slider.value) > 0 ? "+" : ""}${Number(slider.value).toFixed(1)} stops`;
      ask();
    };
    const boxes = { patches: document.getElementById("patches"), lines: document.getElementById("lines") };
    const choose = () => {
      patches.visible = boxes.patches.checked;
      smooth.visible = !boxes.patches.checked;
      lines.visible = boxes.lines.checked;
      ask();
    };
    const flip = (box) => {
      box.checked = !box.checked;
      choose();
    };
    const brighter = (stops) => {
      slider.value = Number(slider.value) + stops;
      expose();
    };
    const presses = {
      p: () => flip(boxes.patches), l: () => flip(boxes.lines), "+": () => brighter(0.5), "-": () => brighter(-0.5),
      r: () => { reset(); ask(); },
    };
    addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const onSlider = event.target === slider && event.code.startsWith("Arrow");
      if (steps[event.code] && !onSlider) {
        if (held.size === 0) before = performance.now();
        held.add(event.code);
        event.preventDefault();
        ask();
      } else if (presses[event.key]) {
        presses[event.key]();
      }
    });
    addEventListener("keyup", (event) => held.delete(event.code));
    addEventListener("blur", () => held.clear());
    let last = null;  // where the mouse button was pressed, or the mouse was then
    canvas.addEventListener("pointerdown", (event) => {
      last = event;
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!last) return;
      turn((event.clientX - last.clientX) * 0.004, (event.clientY - last.clientY) * 0.004);
      last = event;
      ask();
    });
    canvas.addEventListener("pointerup", () => { last = null; });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      camera.position.addScaledVector(direction(), -Math.sign(event.deltaY) * size / 20);
      ask();
    }, { passive: false });
    slider.addEventListener("input", expose);
    boxes.patches.addEventListener("change", choose);
    boxes.lines.addEventListener("change", choose);
    document.getElementById("reset").addEventListener("click", presses.r);
    addEventListener("resize", fit);
    reset();
    expose();
    fit();
    window.walk = { measured };
  }

  try {
    start();
  } catch (problem) {
    const words = document.createElement("p");
    words.className = "missing";
    words.textContent = `This page draws with WebGL, which this browser does not offer (${problem.message}).`;
    canvas.replaceWith(words);
  }
}
