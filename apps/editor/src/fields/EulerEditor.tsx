import type { EulerField } from '@farol/engine/fields';
import { MathUtils } from 'three';
import type { ReactNode } from 'react';
import { toDegrees } from './AngleEditor';
import type { FieldEditorProps } from '../api/FieldEditorProps';
import { TripleEditor } from './TripleEditor';

export function EulerEditor({ onCommit, ...rest }: FieldEditorProps<EulerField>): ReactNode {
  return (
    <TripleEditor {...rest} step={1} toShown={toDegrees} fromShown={MathUtils.degToRad} onCommit={() => onCommit()} />
  );
}
