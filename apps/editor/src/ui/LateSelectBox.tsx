import { lazy, type ReactNode, Suspense } from 'react';
import { Icon } from './Icon';
import type { SelectBoxProps } from './SelectBox';

const SelectBox = lazy(async () => ({ default: (await import('./SelectBox')).SelectBox }));

/** A `SelectBox` in what is there at the first frame: its code comes after that, and a box of its looks stands there until then. */
export function LateSelectBox<T extends string>(props: SelectBoxProps<T>): ReactNode {
  const { value, options, label } = props;
  const waiting = (
    <button type="button" className="select" aria-label={label} disabled>
      <span className="select-value">{options.find((option) => option.value === value)?.label ?? value ?? '—'}</span>
      <Icon name="down" size={12} />
    </button>
  );
  return (
    <Suspense fallback={waiting}>
      {/* lazy() forgets the type of the values */}
      <SelectBox {...(props as unknown as SelectBoxProps<string>)} />
    </Suspense>
  );
}
