import { Checkbox } from '@base-ui/react/checkbox';
import type { ReactNode } from 'react';
import { Icon } from './Icon';

interface ToggleProps {
  /** State shown; null when the edited objects have different ones. */
  readonly value: boolean | null;
  readonly label: string;
  readonly description?: string;
  readonly disabled?: boolean;
  onChange(value: boolean): void;
}

export function Toggle({ value, label, description, disabled, onChange }: ToggleProps): ReactNode {
  return (
    <Checkbox.Root
      className="checkbox"
      checked={value ?? false}
      indeterminate={value === null}
      disabled={disabled}
      aria-label={label}
      aria-description={description}
      title={description}
      onCheckedChange={(next) => onChange(next)}
    >
      <Checkbox.Indicator className="checkbox-mark" keepMounted={false}>
        {value === null ? <span className="checkbox-dash" /> : <Icon name="check" size={12} />}
      </Checkbox.Indicator>
    </Checkbox.Root>
  );
}
