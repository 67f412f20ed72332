import { matchesFilter } from '@farol/editing';
import { createContext, useContext } from 'react';

/** The words that fields are filtered by; none shows all. */
export const FieldFilter = createContext<readonly string[]>([]);

/** Title of the section that a field is in: its words find all of its fields. */
export const SectionTitle = createContext('');

/** Whether a field is found: each word is in its label, its name, or the title of its section. */
export function useIsFound(...texts: readonly string[]): boolean {
  const words = useContext(FieldFilter);
  const title = useContext(SectionTitle);
  return matchesFilter(words, [...texts, title]);
}

/** Whether fields are filtered: then sections show what is found in them, folded or not. */
export const useIsFiltering = (): boolean => useContext(FieldFilter).length > 0;
