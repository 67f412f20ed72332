import { matchesFilter } from '@farol/editing';
import { createContext, useContext } from 'react';

/** Words of the inspector's search; empty to show all fields. */
export const FieldFilter = createContext<readonly string[]>([]);

/** Title of the section around a field; a search that matches the title shows all of its fields. */
export const SectionTitle = createContext('');

/** Whether a field matches the search: each word occurs in its label, its name, or its section's title. */
export function useIsFound(...texts: readonly string[]): boolean {
  const words = useContext(FieldFilter);
  const title = useContext(SectionTitle);
  return matchesFilter(words, [...texts, title]);
}

/** Whether a search is active; sections then show matching fields, folded or not. */
export const useIsFiltering = (): boolean => useContext(FieldFilter).length > 0;
