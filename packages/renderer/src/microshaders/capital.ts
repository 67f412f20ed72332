/** Returns the text with its first letter capitalised. */
export function capital<Text extends string>(text: Text): Capitalize<Text> {
  return (text[0].toUpperCase() + text.slice(1)) as Capitalize<Text>;
}
