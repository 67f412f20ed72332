import type { CurveField } from '@farol/engine/fields';
import { lazy, type ReactNode } from 'react';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { CurvePicture } from './keys/CurvePicture';
import { KeysPopover } from './keys/KeysPopover';
import { valueRange } from './keys/valueRange';

const CurvePopup = lazy(async () => ({ default: (await import('./keys/CurvePopup')).CurvePopup }));

/** A thumbnail of a curve, which opens its graph. */
export function CurveEditor(props: FieldEditorProps<CurveField>): ReactNode {
  const { field, value, mixed, label, description, disabled } = props;
  const picture =
    mixed || value === null ? (
      <span className="keys-mixed">—</span>
    ) : (
      <CurvePicture curve={value} range={valueRange(field, value)} />
    );
  return (
    <KeysPopover {...{ label, description, disabled, picture }}>
      <CurvePopup {...props} />
    </KeysPopover>
  );
}
