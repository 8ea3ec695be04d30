// A statement that a source has in several lines, each below an opening bracket of the first, as one.
const statements_of = (lines) => {
  const indent = (line) => line.length - line.trimStart().length;
  return lines.reduce((all, line) => {
    const last = all.at(-1) ?? ";";
    const goes_on = !/[;{}:]$|\/\//.test(last) && last.trim() && indent(line) > indent(last) + 4;
    return goes_on ? [...all.slice(0, -1), `${last} ${line.trimStart()}`.replace(/\( /, "(")] : [...all, line];
  }, []);
};

// Breaks a line of code or pseudo-code as a formatter would, into lines of at most `columns` letters: {words, remark}.
const lines_within = (() => {
  const step = 4;  // further to the right, where a line goes on

  // A remark stands behind at least two spaces, and so does the next statement, or what is done on a condition.
  function parts_of(line) {
    const [, first, rest] = /^( *\S+(?: \S+)*) {2,}(\S.*)$/.exec(line) ?? [];
    return first ? [first, rest] : null;
  }

  // How good a space is to break at, best first: few open brackets, behind a comma or before an operator, far to the right.
  function break_of(line, columns) {
    const indent = line.length - line.trimStart().length;
    let depth = 0, best = null;
    for (let at = indent; at <= columns && at < line.length; ++at) {
      if ("([{".includes(line[at])) ++depth;
      if (")]}".includes(line[at])) --depth;
      if (line[at] !== " " || at < indent + (columns - indent) / 3) continue;
      const good = ",;:".includes(line[at - 1]) || /^ (?:[-+*\/?:=<>]|&&|\|\|)\S* /.test(line.slice(at));
      const cost = 2 * depth + (good ? 0 : 3);
      if (!best || cost <= best.cost) best = { at, cost };
    }
    return best?.at ?? columns;
  }

  // What goes on stands further to the right, but once only; a comment goes on as a comment.
  function broken(line, columns, remark, further = step) {
    if (line.length <= columns) return [{ words: line, remark }];
    const indent = line.length - line.trimStart().length, at = break_of(line, columns);
    const begin = remark ? " ".repeat(indent) + (line.startsWith("//", indent) ? "// " : "") : " ".repeat(indent + further);
    return [{ words: line.slice(0, at), remark }, ...broken(begin + line.slice(at).trimStart(), columns, remark, 0)];
  }

  return function lines_within(line, columns) {
    if (line.length <= columns) return [{ words: line, remark: false }];
    const parts = parts_of(line), indent = line.length - line.trimStart().length;
    if (!parts) return broken(line, columns, line.trimStart().startsWith("//"));
    const [first, rest] = parts, moved = (by) => " ".repeat(indent + by) + rest;
    if (rest.startsWith("//")) return [...broken(moved(0), columns, true), ...lines_within(first, columns)];
    if (first.endsWith(";")) return [...broken(first, columns, false), ...lines_within(moved(0), columns)];
    const is_action = first.endsWith(":");
    return [...broken(first, columns, false), ...broken(moved(step), columns, !is_action)];
  };
})();
