import type {
  CustomField,
  FieldType,
  FieldValue,
  AngleField,
  AssetField,
  AssetType,
  BooleanField,
  ChoiceField,
  ColourField,
  Curve,
  CurveField,
  EulerField,
  Gradient,
  GradientField,
  NumberField,
  ObjectField,
  StringField,
  Vector3Field,
  Vector3Tuple,
} from './Field';

/** Options of a field besides its default; `help` should be among them. */
type Options<F> = Omit<F, 'kind' | 'default' | 'options' | 'assetType' | 'help'> & { readonly help?: string };
type WithoutUnit<F> = Omit<F, 'unit'>;

/** Declares a field for a number; `options` gives unit, min, max, step and integer. */
export const number = (value: number, options: Options<NumberField> = {}): NumberField => ({
  kind: 'number',
  default: value,
  help: '',
  ...options,
});

/** Declares a field for an angle (radians). */
export const angle = (radians: number, options: WithoutUnit<Options<AngleField>> = {}): AngleField => ({
  kind: 'angle',
  default: radians,
  unit: 'rad',
  help: '',
  ...options,
});

/** Declares a field for true or false. */
export const boolean = (value: boolean, options: Options<BooleanField> = {}): BooleanField => ({
  kind: 'boolean',
  default: value,
  help: '',
  ...options,
});

/** Declares a field for free text. */
export const string = (value: string, options: Options<StringField> = {}): StringField => ({
  kind: 'string',
  default: value,
  help: '',
  ...options,
});

/** Declares a field whose value is one of `options`. */
export const choice = <const Option extends string>(
  value: NoInfer<Option>,
  options: readonly Option[],
  rest: Options<ChoiceField<Option>> = {},
): ChoiceField<Option> => ({ kind: 'choice', default: value, options, help: '', ...rest });

/** Declares a field for three coordinates. */
export const vector3 = (value: Vector3Tuple, options: Options<Vector3Field> = {}): Vector3Field => ({
  kind: 'vector3',
  default: value,
  help: '',
  ...options,
});

/** Declares a field for three Euler angles (radians, order XYZ). */
export const euler = (value: Vector3Tuple, options: WithoutUnit<Options<EulerField>> = {}): EulerField => ({
  kind: 'euler',
  default: value,
  unit: 'rad',
  help: '',
  ...options,
});

/** Declares a field for a linear RGB colour. */
export const colour = (value: Vector3Tuple, options: Options<ColourField> = {}): ColourField => ({
  kind: 'colour',
  default: value,
  help: '',
  ...options,
});

/** Declares a field for a number over a time from 0 to 1; `options` gives unit, min, max and step. */
export const curve = (value: Curve, options: Options<CurveField> = {}): CurveField => ({
  kind: 'curve',
  default: value,
  help: '',
  ...options,
});

/** Declares a field for a colour and an opacity over a time from 0 to 1. */
export const gradient = (value: Gradient, options: Options<GradientField> = {}): GradientField => ({
  kind: 'gradient',
  default: value,
  help: '',
  ...options,
});

/** Declares a field for the name of an asset, or null for none. */
export const asset = (assetType: AssetType, value: string | null, options: Options<AssetField> = {}): AssetField => ({
  kind: 'asset',
  default: value,
  assetType,
  help: '',
  ...options,
});

/** Declares a field for the id of a GameObject of the scene, or null for none. */
export const object = (value: string | null, options: Options<ObjectField> = {}): ObjectField => ({
  kind: 'object',
  default: value,
  help: '',
  ...options,
});

/** Declares a field of a custom type. */
export const custom = <const Value extends FieldValue>(
  type: FieldType,
  value: Value,
  options: Options<Omit<CustomField, 'type'>> = {},
): Omit<CustomField, 'default'> & { readonly default: Value } => ({
  kind: 'custom',
  type,
  default: value,
  help: '',
  ...options,
});
