/** Three numbers, never changed in place: [x, y, z] or [r, g, b]. */
export type Vector3Tuple = readonly [number, number, number];

/** A key of a curve: its time, from 0 to 1, and the value there. */
export type CurveKey = readonly [time: number, value: number];

/**
 * A number over time, never changed in place: 1 to 64 keys by ascending time. Linear between keys, constant before the
 * first and after the last; at the time of two keys the second one applies.
 */
export type Curve = readonly CurveKey[];

/**
 * Key of a gradient: time (0 to 1), linear colour and opacity (0 to 1). Null for a part that the key does not set, so
 * that colour and opacity can have keys at different times.
 */
export type GradientKey = readonly [time: number, colour: Vector3Tuple | null, opacity: number | null];

/** A key of a gradient's colour. */
export type ColourKey = readonly [time: number, colour: Vector3Tuple];

/** Colour and opacity over time, as `Curve`: 1 to 64 keys, at least one with a colour and one with an opacity. */
export type Gradient = readonly GradientKey[];

/** Condition of a field's visibility: another field of the same owner, itself visible, has one of these values. */
export interface FieldCondition {
  readonly field: string;
  readonly equals: readonly unknown[];
  /** Second condition that must hold for the field to be visible. */
  readonly and?: FieldCondition;
}

/** Labels and units of a field by the value of another field of the same owner, which is a choice field. */
export interface FieldVariants {
  readonly field: string;
  readonly of: Readonly<Record<string, { readonly label?: string; readonly unit?: string }>>;
}

interface FieldBase {
  /** Help text of one line, shown as a tooltip. */
  readonly help: string;
  /** Label in place of the field's name. */
  readonly label?: string;
  readonly visibleWhen?: FieldCondition;
  /** Other labels or units for certain values of another field. */
  readonly variants?: FieldVariants;
  /** Title of the group in which the inspector shows the field; none when absent. */
  readonly group?: string;
  /** Whether the field only serves older files: visible only while its value is not the default. */
  readonly deprecated?: boolean;
  /** For a view: name of the field of the same owner of whose value it edits a part; files store only that field. */
  readonly viewOf?: string;
  /** Name of another field of the owner in whose row this one is edited; it has no row of its own. */
  readonly besideField?: string;
  /** Whether the field is shown, but cannot be edited by hand. */
  readonly readOnly?: boolean;
}

/** A field that holds a finite number. */
export interface NumberField extends FieldBase {
  readonly kind: 'number';
  readonly default: number;
  /** SI unit, such as 'm' or 'm/s'; none for a pure number. */
  readonly unit?: string;
  /** Units by the value of another field of the owner; `unit` then lists all of them, as in 'cd or lx'. */
  readonly unitBy?: { readonly field: string; readonly units: Readonly<Record<string, string>> };
  /** Smallest value allowed. */
  readonly min?: number;
  /** Largest value allowed. */
  readonly max?: number;
  /** Step when a number is dragged. */
  readonly step?: number;
  readonly integer?: boolean;
  /** Factor from the stored to the displayed number, for editors that display another unit than `unit`. */
  readonly scale?: number;
  /** Special input of editors: a light's intensity with its unit, or a colour temperature. */
  readonly input?: 'intensity' | 'temperature';
}

/** Angle in radians; the apps show degrees. */
export interface AngleField extends FieldBase {
  readonly kind: 'angle';
  readonly default: number;
  readonly unit: 'rad';
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
}

/** A field that holds true or false. */
export interface BooleanField extends FieldBase {
  readonly kind: 'boolean';
  readonly default: boolean;
}

/** A field that holds text. */
export interface StringField extends FieldBase {
  readonly kind: 'string';
  readonly default: string;
  /** Name of an owner's property that lists the allowed texts, besides '' for none; any text when absent. */
  readonly choices?: string;
  /** Kind of text: 'key' is the code of a key (KeyboardEvent.code), entered by pressing it; any text when absent. */
  readonly input?: 'key';
}

/** A field that holds one of several names. */
export interface ChoiceField<Option extends string = string> extends FieldBase {
  readonly kind: 'choice';
  readonly default: Option;
  readonly options: readonly Option[];
  /** Labels of options that are not displayed by their name. */
  readonly optionLabels?: { readonly [K in Option]?: string };
}

/** A field that holds three numbers, x, y and z. */
export interface Vector3Field extends FieldBase {
  readonly kind: 'vector3';
  readonly default: Vector3Tuple;
  readonly unit?: string;
  /** Smallest value of each coordinate. */
  readonly min?: number;
  /** Largest value of each coordinate. */
  readonly max?: number;
  readonly step?: number;
}

/** Three angles in radians, applied in three's order 'XYZ'. */
export interface EulerField extends FieldBase {
  readonly kind: 'euler';
  readonly default: Vector3Tuple;
  readonly unit: 'rad';
}

/** Colour with linear sRGB primaries; each channel 0 or more, above 1 allowed. */
export interface ColourField extends FieldBase {
  readonly kind: 'colour';
  readonly default: Vector3Tuple;
}

/** A number over a time from 0 to 1. */
export interface CurveField extends FieldBase {
  readonly kind: 'curve';
  readonly default: Curve;
  /** SI unit of the values; none for pure numbers. */
  readonly unit?: string;
  /** Smallest value allowed of a key. */
  readonly min?: number;
  /** Largest value allowed of a key. */
  readonly max?: number;
  readonly step?: number;
}

/** A colour and an opacity over a time from 0 to 1. */
export interface GradientField extends FieldBase {
  readonly kind: 'gradient';
  readonly default: Gradient;
}

/** Types of assets that a field may name. */
export type AssetType =
  | 'mesh'
  | 'texture'
  | 'material'
  | 'shader'
  | 'model'
  | 'script'
  | 'clip'
  | 'sound'
  | 'profile'
  | 'surface'
  | 'bake';

/** A field with the name of an asset of the scene's AssetLibrary, or null. */
export interface AssetField extends FieldBase {
  readonly kind: 'asset';
  readonly default: string | null;
  readonly assetType: AssetType;
}

/** A field with the id of a GameObject of the same scene, or null. */
export interface ObjectField extends FieldBase {
  readonly kind: 'object';
  readonly default: string | null;
  /** Label for the value null; 'No object' when absent. */
  readonly noneLabel?: string;
}

/** A kind of field defined outside of the engine. */
export interface FieldType {
  /** Name by which editors find a control for the type's fields. */
  readonly name: string;
  /** Allowed values in words, as the end of "must be …". */
  readonly allows: string;
  /** Whether the type allows a value. NaN and infinities are always refused. */
  check(value: FieldValue): boolean;
}

/** Field of a custom type, which checks its own values. */
export interface CustomField extends FieldBase {
  readonly kind: 'custom';
  readonly type: FieldType;
  readonly default: FieldValue;
}

/** Declaration of a field, of any kind. */
export type Field =
  | NumberField
  | AngleField
  | BooleanField
  | StringField
  | ChoiceField
  | Vector3Field
  | EulerField
  | ColourField
  | CurveField
  | GradientField
  | AssetField
  | ObjectField
  | CustomField;

/** Kinds of fields. */
export type FieldKind = Field['kind'];
/** Declarations of fields by name. */
export type FieldTable = Readonly<Record<string, Field>>;
/** Values that fields can have, and files can hold. */
export type FieldValue = number | boolean | string | null | Vector3Tuple | Curve | Gradient;

/** The type of a field's value. */
export type ValueOf<F extends Field> = F extends { kind: 'number' | 'angle' }
  ? number
  : F extends { kind: 'boolean' }
    ? boolean
    : F extends ChoiceField<infer Option>
      ? Option
      : F extends { kind: 'string' }
        ? string
        : F extends { kind: 'vector3' | 'euler' | 'colour' }
          ? Vector3Tuple
          : F extends { kind: 'curve' }
            ? Curve
            : F extends { kind: 'gradient' }
              ? Gradient
              : F extends { kind: 'custom'; default: infer Default }
                ? Widened<Default>
                : string | null;

/** Type of a custom field's values, from its default. */
type Widened<Default> = Default extends number
  ? number
  : Default extends boolean
    ? boolean
    : Default extends string
      ? string
      : Default extends Vector3Tuple
        ? Vector3Tuple
        : FieldValue;

/** The values of a table of fields, as typed properties. */
export type ValuesOf<F extends FieldTable> = { -readonly [K in keyof F]: ValueOf<F[K]> };
