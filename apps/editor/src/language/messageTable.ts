/**
 * Messages of the engine, which has English ones alone, in a language: by the English text with `{name}` for what the
 * engine fills in. A test holds that the engine's sources have each of them.
 */
export type MessageTable = Readonly<Record<string, string>>;

const escaped = (text: string): string => text.replaceAll(/[.*+?^${}()|[\]\\]/g, String.raw`\$&`);

/** The pattern of a message. What is filled in is as short as it can be; at the end it is all that follows. */
function patternOf(english: string): RegExp {
  const parts = english.split(/\{\w+\}/);
  const last = parts.length - 1;
  const pattern = parts
    .map((part, i) => escaped(part) + (i === last ? '' : i === last - 1 && parts[last] === '' ? '([^]+)' : '([^]+?)'))
    .join('');
  // a message begins where a sentence or a clause does
  return new RegExp(`(?<![\\p{L}\\p{N}])${pattern}`, 'gu');
}

/**
 * Puts the messages of a table that a text is, or holds, into another language: the rest stays as it is.
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
