import type { GameObject, Scene } from '@farol/engine';

/** The words of a query, in lower case. */
export const wordsOf = (query: string): string[] => query.toLowerCase().split(/\s+/).filter(Boolean);

/** Whether each word occurs in the object's name, in the name of one of its components, or in a tag. */
function matches({ name, components, tags }: GameObject, words: readonly string[]): boolean {
  const lower = name.toLowerCase();
  return words.every(
    (word) =>
      lower.includes(word) ||
      components.some(({ typeName }, i) => i > 0 && typeName.toLowerCase().includes(word)) ||
      tags.some((tag) => tag.toLowerCase().includes(word)),
  );
}

/** Ids of the objects that match all words, in tree order. */
export function matching(scene: Scene, words: readonly string[]): string[] {
  const ids: string[] = [];
  scene.traverse((object) => {
    if (matches(object, words)) ids.push(object.id);
  });
  return ids;
}
