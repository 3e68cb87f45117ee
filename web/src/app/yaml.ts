import { Document, isCollection, isMap, isPair, isScalar, type Node, parseDocument, Scalar, visit } from "yaml";

/** Longest line in characters, if it can be broken. */
const LONGEST = 120;
/** Words that some version of YAML reads as another type than text. */
const TAKEN = /^(y|n|yes|no|on|off|true|false|null|nan|inf|infinity)$/i;
const BARE = /^[a-z_][a-z0-9_.]*$/i;
/** Words separated by single spaces: a folded block keeps them unchanged. */
const FOLDS = /^[\x21-\x7e\u00a1-\ud7ff]+( [\x21-\x7e\u00a1-\ud7ff]+)+$/;
/** Reads every scalar as text, so that numbers stay as they are written, to the last bit. */
const AS_TEXT = { schema: "failsafe" } as const;
const LAYOUT = { flowCollectionPadding: false, doubleQuotedAsJSON: true, lineWidth: LONGEST };

/** Writes a JSON object as YAML in the layout of the gallery's files; reading it gives the same values. */
export function yamlOf(json: string): string {
  const file = parseDocument(json, AS_TEXT);
  if (!isMap(file.contents)) throw new TypeError("found no object");
  file.contents.flow = false;
  visit(file, { Scalar: (_, scalar) => unquote(scalar) });
  visit(file, { Value: (key, value, path) => (key === null || key === "key" ? undefined : layOut(value, path)) });
  return file.toString(LAYOUT);
}

function unquote(scalar: Scalar) {
  const text = String(scalar.value);
  if (scalar.type === Scalar.QUOTE_DOUBLE && BARE.test(text) && !TAKEN.test(text)) scalar.type = Scalar.PLAIN;
}

/**
 * Breaks a value over several lines if it does not fit beside its name; a large part of the file has an empty line
 * above it.
 */
function layOut(value: Node, path: readonly unknown[]) {
  const [parent, above] = path.slice(-2);
  const key = isPair(above) && isScalar(above.key) ? above.key : null;
  const indent = " ".repeat(2 * path.filter(isCollection).length - 2);
  const inline = new Document(value, AS_TEXT).toString({ ...LAYOUT, collectionStyle: "flow" }).trimEnd();
  if (!inline.includes("\n") && `${indent}${key ? `${key}: ` : "- "}${inline}`.length <= LONGEST) return visit.SKIP;
  if (isCollection(value)) value.flow = false;
  else if (key && isScalar(value) && FOLDS.test(String(value.value))) value.type = Scalar.BLOCK_FOLDED;
  if (key && indent === "" && isMap(parent) && parent.items[0] !== above) key.spaceBefore = true;
}
