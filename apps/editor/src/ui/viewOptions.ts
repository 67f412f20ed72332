import { type View, views } from '@farol/renderer';
import { viewLabel } from '../actions/display';
import type { SelectOption } from './SelectBox';

/** The debug views, as options of a select box. */
export const viewOptions = (): SelectOption<View>[] => views.map((value) => ({ value, label: viewLabel(value) }));
