import { techniques, type TechniqueName } from '@farol/renderer';
import type { SelectOption } from './SelectBox';

/** The techniques, as lines of a menu. */
export const techniqueOptions = (): SelectOption<TechniqueName>[] =>
  (Object.keys(techniques) as TechniqueName[]).map((value) => ({
    value,
    label: techniques[value].label,
    help: techniques[value].help,
  }));
