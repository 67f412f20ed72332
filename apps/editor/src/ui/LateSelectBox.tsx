import type { ReactNode } from 'react';
import { Icon } from './Icon';
import { lateComponent } from './lateComponent';
import type { SelectBoxProps } from './SelectBox';

const LateBox = lateComponent<SelectBoxProps<string>>(
  async () => (await import('./SelectBox')).SelectBox,
  ({ value, options, label }) => (
    <button type="button" className="select" aria-label={label} disabled>
      <span className="select-value one-line">
        {options.find((option) => option.value === value)?.label ?? value ?? '—'}
      </span>
      <Icon name="down" size={12} />
    </button>
  ),
);

/** A `SelectBox` for the first frame: its code is fetched afterwards; until then a similar placeholder is shown. */
export function LateSelectBox<T extends string>(props: SelectBoxProps<T>): ReactNode {
  // lateComponent() loses the type of the values
  return <LateBox {...(props as unknown as SelectBoxProps<string>)} />;
}
