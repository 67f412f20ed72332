import type { ReactNode } from 'react';
import { SelectBox, type SelectOption } from './SelectBox';
import { Toggle } from './Toggle';

interface SettingRowProps<T> {
  readonly label: string;
  readonly value: T;
  onChange(value: T): void;
}

/** Row with a switch, for a setting of a tool or dialog. */
export function SwitchRow(props: SettingRowProps<boolean>): ReactNode {
  return (
    <div className="setting-row">
      <span aria-hidden="true">{props.label}</span>
      <Toggle {...props} />
    </div>
  );
}

interface ChoiceRowProps<T extends string> extends SettingRowProps<T> {
  readonly options: readonly SelectOption<T>[];
}

/** Row with a list of choices, for a setting of a tool or dialog. */
export function ChoiceRow<T extends string>(props: ChoiceRowProps<T>): ReactNode {
  return (
    <div className="setting-row">
      <span aria-hidden="true">{props.label}</span>
      <SelectBox {...props} />
    </div>
  );
}
