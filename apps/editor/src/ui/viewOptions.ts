import { type View, views } from '@farol/renderer';
import { viewLabel } from '../actions/pictureActions';
import type { SelectOption } from './SelectBox';

/** The views, as lines of a menu. */
export const viewOptions = (): SelectOption<View>[] => views.map((value) => ({ value, label: viewLabel(value) }));
