import type { ReactNode } from 'react';
import { SelectBox, type SelectOption } from './SelectBox';
import { Toggle } from './Toggle';

interface SettingRowProps<T> {
  readonly label: string;
  readonly value: T;
  /** CSS class of the row; 'tool-row' when absent. */
  readonly className?: string;
  onChange(value: T): void;
}

/** Row with a switch, for a setting of a tool or dialog. */
export function SwitchRow({ className = 'tool-row', ...props }: SettingRowProps<boolean>): ReactNode {
  return (
    <div className={className}>
      <span aria-hidden="true">{props.label}</span>
      <Toggle {...props} />
    </div>
  );
}

interface ChoiceRowProps<T extends string> extends SettingRowProps<T> {
  readonly options: readonly SelectOption<T>[];
}

/** Row with a list of choices, for a setting of a tool or dialog. */
export function ChoiceRow<T extends string>({ className = 'tool-row', ...props }: ChoiceRowProps<T>): ReactNode {
  return (
    <div className={className}>
      <span aria-hidden="true">{props.label}</span>
      <SelectBox {...props} />
    </div>
  );
}
