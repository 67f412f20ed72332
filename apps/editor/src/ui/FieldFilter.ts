import { createContext, useContext } from 'react';

/** The words that fields are filtered by; none shows all. */
export const FieldFilter = createContext<readonly string[]>([]);

/** Title of the section that a field is in: its words find all of its fields. */
export const SectionTitle = createContext('');

export const wordsOfFilter = (text: string): readonly string[] => text.toLowerCase().split(/\s+/).filter(Boolean);

/** Whether a field is found: each word is in its label, its name, or the title of its section. */
export function useIsFound(...texts: readonly string[]): boolean {
  const words = useContext(FieldFilter);
  const title = useContext(SectionTitle);
  if (words.length === 0) return true;
  const text = [...texts, title].join('\n').toLowerCase();
  return words.every((word) => text.includes(word));
}

/** Whether fields are filtered: then sections show what is found in them, folded or not. */
export const useIsFiltering = (): boolean => useContext(FieldFilter).length > 0;
