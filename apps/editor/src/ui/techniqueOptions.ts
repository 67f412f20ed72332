import { t } from '@farol/editing';
import type { FarolRenderer, TechniqueName } from '@farol/renderer';
import type { SelectOption } from './SelectBox';

export const techniqueOptions = ({ techniques }: FarolRenderer): SelectOption<TechniqueName>[] =>
  Object.entries(techniques).map(([value, { label, help }]) => ({
    value: value as TechniqueName,
    label: t(label),
    help: t(help),
  }));
