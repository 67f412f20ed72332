import type { ReactNode } from 'react';
import { SelectBox, type SelectOption } from './SelectBox';
import { Toggle } from './Toggle';

interface SettingRowProps<T> {
  readonly label: string;
  readonly value: T;
  /** Class of the row; that of a tool's by default. */
  readonly className?: string;
  onChange(value: T): void;
}

/** A setting of a tool or dialog that is on or off. */
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

/** A setting of a tool or dialog that is one of several. */
export function ChoiceRow<T extends string>({ className = 'tool-row', ...props }: ChoiceRowProps<T>): ReactNode {
  return (
    <div className={className}>
      <span aria-hidden="true">{props.label}</span>
      <SelectBox {...props} />
    </div>
  );
}
