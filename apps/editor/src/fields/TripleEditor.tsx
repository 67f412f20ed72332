import { numberDisplay, withCoordinate } from '@farol/editing';
import type { EulerField, Vector3Field } from '@farol/engine/fields';
import { type ReactNode, useMemo } from 'react';
import { NumberInput } from '../ui/NumberInput';
import type { FieldEditorProps } from '../api/FieldEditorProps';

const axes = ['x', 'y', 'z'] as const;

/** Three numbers side by side: a vector, or Euler angles in degrees. */
export function TripleEditor(props: FieldEditorProps<Vector3Field | EulerField>): ReactNode {
  const { field, value, parts, label, onPreview, onCommit, ...rest } = props;
  const { unit, min, max, step, toShown, fromShown } = useMemo(() => numberDisplay(field), [field]);
  return (
    <div className="triple" role="group" aria-label={label}>
      {axes.map((axis, i) => {
        const coordinate = value?.[i] ?? parts?.[i] ?? null;
        return (
          <NumberInput
            {...rest}
            {...{ unit, min, max, step }}
            key={axis}
            digits="short"
            value={coordinate === null ? null : toShown(coordinate)}
            label={`${label} ${axis}`}
            handle={<span className={`axis axis-${axis}`}>{axis}</span>}
            onPreview={(next) => onPreview(withCoordinate(i, fromShown(next)))}
            onPreviewEach={(update) => onPreview(withCoordinate(i, (before) => fromShown(update(toShown(before)))))}
            onCommit={() => onCommit()}
          />
        );
      })}
    </div>
  );
}
