import { Select } from '@base-ui/react/select';
import type { ReactNode } from 'react';
import { Icon } from './Icon';

export interface SelectOption<T extends string> {
  readonly value: T;
  readonly label: string;
  /** Short description below the label. */
  readonly help?: string;
}

export interface SelectBoxProps<T extends string> {
  /** Chosen value; null when the edited objects have different ones. */
  readonly value: T | null;
  readonly options: readonly SelectOption<T>[];
  readonly label: string;
  readonly description?: string;
  readonly disabled?: boolean;
  onChange(value: T): void;
}

/** Chooses one of several values from a list. */
export function SelectBox<T extends string>(props: SelectBoxProps<T>): ReactNode {
  const { value, options, label, description, disabled, onChange } = props;
  const current = options.find((option) => option.value === value);
  return (
    <Select.Root
      value={value}
      disabled={disabled}
      onValueChange={(next) => {
        if (next !== null) onChange(next);
      }}
    >
      <Select.Trigger className="select" aria-label={label} aria-description={description} title={current?.help}>
        <span className="select-value one-line">{current?.label ?? value ?? '—'}</span>
        <Icon name="down" size={12} />
      </Select.Trigger>
      <Select.Portal>
        <Select.Positioner className="positioner" sideOffset={3} alignItemWithTrigger={false}>
          <Select.Popup className="popup">
            {options.map((option) => (
              <Select.Item key={option.value} value={option.value} className="menu-item">
                <span className="menu-check">
                  <Select.ItemIndicator>
                    <Icon name="check" size={12} />
                  </Select.ItemIndicator>
                </span>
                <span className="menu-text">
                  <Select.ItemText>{option.label}</Select.ItemText>
                  {option.help && <span className="menu-help">{option.help}</span>}
                </span>
              </Select.Item>
            ))}
          </Select.Popup>
        </Select.Positioner>
      </Select.Portal>
    </Select.Root>
  );
}
