import { Fragment, type ReactNode } from 'react';
import { languageChanged } from '../language/shownLanguage';
import { useSignal } from './EditorContext';

/** Remounts its children when the language changes, so that no old text stays. */
export function InLanguage({ children }: { children: ReactNode }): ReactNode {
  return <Fragment key={useSignal(languageChanged)}>{children}</Fragment>;
}
