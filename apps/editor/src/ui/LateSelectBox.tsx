import type { ReactNode } from 'react';
import { Icon } from './Icon';
import { lateComponent } from './lateComponent';
import type { SelectBoxProps } from './SelectBox';

const LateBox = lateComponent<SelectBoxProps<string>>(
  async () => (await import('./SelectBox')).SelectBox,
  ({ value, options, label }) => (
    <button type="button" className="select" aria-label={label} disabled>
      <span className="select-value">{options.find((option) => option.value === value)?.label ?? value ?? '—'}</span>
      <Icon name="down" size={12} />
    </button>
  ),
);

/** A `SelectBox` for the first frame: its code is fetched afterwards, and a placeholder that looks alike is shown until then. */
export function LateSelectBox<T extends string>(props: SelectBoxProps<T>): ReactNode {
  // lateComponent() forgets the type of the values
  return <LateBox {...(props as unknown as SelectBoxProps<string>)} />;
}
