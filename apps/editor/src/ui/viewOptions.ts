import { t } from '@farol/editing';
import { type View, views } from '@farol/renderer';
import type { SelectOption } from './SelectBox';

/** What a view is called in English. */
export const englishViewLabel = (view: View): string =>
  view.charAt(0).toUpperCase() + view.slice(1).replaceAll('-', ' ');

/** What a view is called, in the language that is shown. */
export const viewLabel = (view: View): string => t(englishViewLabel(view));

/** The views, as lines of a menu. */
export const viewOptions = (): SelectOption<View>[] => views.map((value) => ({ value, label: viewLabel(value) }));
