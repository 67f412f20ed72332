import { type View, views } from '@farol/renderer';
import type { SelectOption } from './SelectBox';

/** What a view is called. */
export const viewLabel = (view: View): string => view.charAt(0).toUpperCase() + view.slice(1).replaceAll('-', ' ');

/** The views, as lines of a menu. */
export const viewOptions: readonly SelectOption<View>[] = views.map((value) => ({ value, label: viewLabel(value) }));
