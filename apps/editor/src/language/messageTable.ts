/**
 * Translations of the engine's messages, which are English only, keyed by the English text with `{name}` for
 * parameters. A test checks that the engine's sources contain each text.
 */
export type MessageTable = Readonly<Record<string, string>>;

const escaped = (text: string): string => text.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`);

/** Pattern of a message. Parameters match as little as possible; the last one matches all that follows. */
function patternOf(english: string): RegExp {
  const parts = english.split(/\{\w+\}/);
  const last = parts.length - 1;
  const pattern = parts
    .map((part, i) => escaped(part) + (i === last ? '' : i === last - 1 && parts[last] === '' ? '([^]+)' : '([^]+?)'))
    .join('');
  // matches only at the beginning of a word, where a sentence or clause starts
  return new RegExp(`(?<![\\p{L}\\p{N}])${pattern}`, 'gu');
}

/**
 * Translates messages of a table, and texts that contain them; the rest of a text is unchanged.
 * @returns a function from text to text
 */
export function messageTranslator(table: MessageTable): (text: string) => string {
  const messages = Object.entries(table).map(([english, other]) => ({
    other,
    pattern: patternOf(english),
    names: [...english.matchAll(/\{(\w+)\}/g)].map(([, name]) => name),
  }));
  return (text) => {
    let said = text;
    for (const { pattern, other, names } of messages) {
      said = said.replace(pattern, (_all, ...values: string[]) =>
        other.replace(/\{(\w+)\}/g, (_name, name: string) => values[names.indexOf(name)]),
      );
    }
    return said;
  };
}
