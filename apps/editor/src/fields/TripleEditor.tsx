import type { Vector3Tuple } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { NumberInput } from '../ui/NumberInput';

interface TripleEditorProps {
  /** Null where the values differ. */
  readonly value: Vector3Tuple | null;
  /** What all have in common where the values differ. */
  readonly parts?: readonly (number | null)[];
  readonly label: string;
  readonly description: string;
  readonly disabled: boolean;
  readonly min?: number;
  readonly max?: number;
  readonly step: number;
  readonly unit?: string;
  /** From the field's unit to the one shown, and back. */
  toShown(value: number): number;
  fromShown(value: number): number;
  onPreview(update: (before: Vector3Tuple) => Vector3Tuple): void;
  onCommit(): void;
  onDiscard(): void;
}

const axes = ['x', 'y', 'z'] as const;

/** Three numbers side by side, one for each axis. */
export function TripleEditor({
  value,
  parts,
  label,
  toShown,
  fromShown,
  onPreview,
  ...rest
}: TripleEditorProps): ReactNode {
  const shown = (i: number): number | null => {
    const coordinate = value?.[i] ?? parts?.[i] ?? null;
    return coordinate === null ? null : toShown(coordinate);
  };
  return (
    <div className="triple" role="group" aria-label={label}>
      {axes.map((axis, i) => (
        <NumberInput
          {...rest}
          key={axis}
          digits="short"
          value={shown(i)}
          label={`${label} ${axis}`}
          handle={<span className={`axis axis-${axis}`}>{axis}</span>}
          onPreview={(next) =>
            onPreview(
              (before) => before.map((each, j) => (i === j ? fromShown(next) : each)) as unknown as Vector3Tuple,
            )
          }
        />
      ))}
    </div>
  );
}
