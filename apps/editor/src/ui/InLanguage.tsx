import { Fragment, type ReactNode } from 'react';
import { languageChanged } from '../language/shownLanguage';
import { useSignal } from './EditorContext';

/** Makes what is in it anew once another language is shown, so that no text of the one before stays. */
export function InLanguage({ children }: { children: ReactNode }): ReactNode {
  return <Fragment key={useSignal(languageChanged)}>{children}</Fragment>;
}
