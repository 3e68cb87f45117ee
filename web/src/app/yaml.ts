/** JSON's values with scalars as they are written: numbers pass through untouched, to the last bit. */
type Written = string | Written[] | Map<string, Written>;

const TOKEN = /"(?:[^"\\]|\\.)*"|[{}[\],:]|[^\s{}[\],:"]+/g;
/** Longest line, in characters, where a line can be broken. */
const LONGEST = 120;
/** Words that some version of YAML does not read as text. */
const TAKEN = /^(y|n|yes|no|on|off|true|false|null|nan|inf|infinity)$/i;
const BARE = /^[a-z_][a-z0-9_.]*$/i;
/** Words separated by single spaces: a folded block does not change them. */
const FOLDS = /^[\x21-\x7e\u00a1-\ud7ff]+( [\x21-\x7e\u00a1-\ud7ff]+)+$/;

/** A JSON object as YAML in the layout of the gallery's files; it reads back to the same values. */
export function yamlOf(json: string): string {
  const tokens = json.match(TOKEN) ?? [];
  const top = read(tokens[Symbol.iterator]());
  if (!(top instanceof Map)) throw new TypeError("found no object");
  return Array.from(top, ([name, value], i) => {
    const lines = fieldOf(name, value, "");
    return (i > 0 && lines.includes("\n") ? "\n" : "") + lines;
  }).join("\n").concat("\n");
}

function read(tokens: Iterator<string, undefined>, first = tokens.next().value): Written {
  if (first === undefined) throw new TypeError("found the end of the text");
  if (first === "[") return listFrom(tokens);
  return first === "{" ? fieldsFrom(tokens) : first;
}

function listFrom(tokens: Iterator<string, undefined>): Written[] {
  const list: Written[] = [];
  for (let token = tokens.next().value; token !== "]"; token = tokens.next().value) {
    if (token !== ",") list.push(read(tokens, token));
  }
  return list;
}

function fieldsFrom(tokens: Iterator<string, undefined>): Map<string, Written> {
  const fields = new Map<string, Written>();
  for (let token = tokens.next().value; token !== "}"; token = tokens.next().value) {
    if (token === undefined) throw new TypeError("found the end of the text");
    if (token === ",") continue;
    tokens.next();
    fields.set(bare(token), read(tokens));
  }
  return fields;
}

/** A quoted text, without quotes if it is a plain word. */
function bare(quoted: string): string {
  const inside = quoted.slice(1, -1);
  return quoted.startsWith('"') && BARE.test(inside) && !TAKEN.test(inside) ? inside : quoted;
}

function flow(value: Written): string {
  if (Array.isArray(value)) return `[${value.map(flow).join(", ")}]`;
  if (value instanceof Map) return `{${Array.from(value, ([name, one]) => `${name}: ${flow(one)}`).join(", ")}}`;
  return bare(value);
}

/** `name: value` on one line, or on as many as needed, each after `indent`. */
function fieldOf(name: string, value: Written, indent: string): string {
  const onOne = `${indent}${name}: ${flow(value)}`;
  if (onOne.length <= LONGEST) return onOne;
  if (typeof value === "string") return `${indent}${name}: ${folded(value, `${indent}  `)}`;
  if (Array.isArray(value) && value.every((one) => typeof one === "string")) {
    const words = value.map((one, i) => bare(one) + (i < value.length - 1 ? "," : "]"));
    return `${indent}${name}: [\n${filled(words, `${indent}  `)}`;
  }
  return `${indent}${name}:\n${block(value, `${indent}  `)}`;
}

function block(value: Written, indent: string): string {
  if (value instanceof Map) return Array.from(value, ([name, one]) => fieldOf(name, one, indent)).join("\n");
  if (Array.isArray(value)) return value.map((one) => entryOf(one, indent)).join("\n");
  return indent + bare(value);
}

function entryOf(value: Written, indent: string): string {
  const onOne = `${indent}- ${flow(value)}`;
  if (onOne.length <= LONGEST || typeof value === "string") return onOne;
  return `${indent}- ${block(value, `${indent}  `).slice(indent.length + 2)}`;
}

/** A long text as a folded block, if folding preserves it. */
function folded(quoted: string, indent: string): string {
  const text = quoted.includes("\\") ? "" : quoted.slice(1, -1);
  return quoted.startsWith('"') && FOLDS.test(text) ? `>-\n${filled(text.split(" "), indent)}` : quoted;
}

/** Words in lines, each as full as possible. */
function filled(words: string[], indent: string): string {
  const lines: string[] = [];
  let line = indent;
  for (const word of words) {
    if (line !== indent && line.length + 1 + word.length > LONGEST) {
      lines.push(line);
      line = indent;
    }
    line += line === indent ? word : ` ${word}`;
  }
  return [...lines, line].join("\n");
}
