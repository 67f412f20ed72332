import type { ReactNode } from 'react';
import { NumberInput } from '../../../ui/NumberInput';

interface NumberRowProps {
  readonly label: string;
  readonly value: number;
  readonly step: number;
  readonly min?: number;
  readonly max?: number;
  readonly unit?: string;
  /** Called while the value is typed or dragged, and when it is final. */
  onChange(value: number): void;
}

/** A number setting of a tool, applied while it is edited. */
export function NumberRow({ label, onChange, value, ...rest }: NumberRowProps): ReactNode {
  return (
    <div className="setting-row">
      <span aria-hidden="true">{label}</span>
      <NumberInput {...rest} value={value} label={label} handle={<span className="grip" />} onPreview={onChange} />
    </div>
  );
}

interface TripleRowProps extends Omit<NumberRowProps, 'value' | 'onChange'> {
  readonly value: readonly [number, number, number];
  onChange(value: [number, number, number]): void;
}

/** Three number settings of a tool, along x, y and z. */
export function TripleRow({ label, value, onChange, ...rest }: TripleRowProps): ReactNode {
  return (
    <div className="setting-row triple" role="group" aria-label={label}>
      <span aria-hidden="true">{label}</span>
      {(['x', 'y', 'z'] as const).map((axis, i) => (
        <NumberInput
          key={axis}
          {...rest}
          unit={undefined}
          digits="short"
          value={value[i]}
          label={`${label} ${axis}`}
          handle={<span className={`axis axis-${axis}`}>{axis}</span>}
          onPreview={(next) => {
            const triple: [number, number, number] = [...value];
            triple[i] = next;
            onChange(triple);
          }}
        />
      ))}
    </div>
  );
}
