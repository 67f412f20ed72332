import { lazy, type ReactNode, Suspense } from 'react';
import { Icon } from './Icon';
import type { SelectBoxProps } from './SelectBox';

const SelectBox = lazy(async () => ({ default: (await import('./SelectBox')).SelectBox }));

/**
 * A `SelectBox` for the first frame: its code is fetched afterwards, and a placeholder that looks alike is shown until
 * then.
 */
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
