import type { Field, FieldKind, NumberField } from '@farol/engine/fields';
import { type ComponentType, createElement } from 'react';
import { AssetEditor } from './AssetEditor';
import { BooleanEditor } from './BooleanEditor';
import { ChoiceEditor } from './ChoiceEditor';
import { ColourEditor } from './ColourEditor';
import { CurveEditor } from './CurveEditor';
import { CustomEditor } from './CustomEditor';
import type { FieldEditorProps, OwnerFieldProps } from '../api/FieldEditorProps';
import { GradientEditor } from './GradientEditor';
import { NumberEditor } from './NumberEditor';
import { ObjectEditor } from './ObjectEditor';
import { StringEditor } from './StringEditor';
import { TripleEditor } from './TripleEditor';
import { lateComponent } from '../ui/lateComponent';

type FieldOf<K extends FieldKind> = Extract<Field, { kind: K }>;

/** The editor for each kind of field; complete, as the type ensures. */
export const fieldEditors: { readonly [K in FieldKind]: ComponentType<FieldEditorProps<FieldOf<K>>> } = {
  number: NumberEditor,
  boolean: BooleanEditor,
  string: StringEditor,
  choice: ChoiceEditor,
  vector3: TripleEditor,
  angle: NumberEditor,
  euler: TripleEditor,
  colour: ColourEditor,
  curve: CurveEditor,
  gradient: GradientEditor,
  asset: AssetEditor,
  object: ObjectEditor,
  custom: CustomEditor,
};

const late = (name: 'IntensityEditor' | 'TemperatureEditor'): ComponentType<OwnerFieldProps<NumberField>> =>
  lateComponent<OwnerFieldProps<NumberField>>(
    async () => (await import('./light'))[name],
    (props) => createElement(NumberEditor, props),
  );

/** Editors of number fields that declare an `input`, by its name; fetched when first shown. */
export const numberEditors = { intensity: late('IntensityEditor'), temperature: late('TemperatureEditor') };
