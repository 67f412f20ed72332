/** Three numbers, never changed in place: [x, y, z] or [r, g, b]. */
export type Vector3Tuple = readonly [number, number, number];

/** A field is shown only while another field of the same owner, itself shown, has one of these values. */
export interface FieldCondition {
  readonly field: string;
  readonly equals: readonly unknown[];
  /** Another condition that must hold as well. */
  readonly and?: FieldCondition;
}

interface FieldBase {
  /** One line of help, shown as a tooltip. */
  readonly help: string;
  /** Shown in place of the field's name. */
  readonly label?: string;
  readonly visibleWhen?: FieldCondition;
  /** Title of the group of fields that it stands in; none when absent. */
  readonly group?: string;
  /** Kept for older files: shown only where it is not the default. */
  readonly deprecated?: boolean;
  /** Shown, but not to be edited by hand. */
  readonly readOnly?: boolean;
}

export interface NumberField extends FieldBase {
  readonly kind: 'number';
  readonly default: number;
  /** SI unit, such as 'm' or 'm/s'; none for a pure number. */
  readonly unit?: string;
  /** Smallest value allowed. */
  readonly min?: number;
  /** Largest value allowed. */
  readonly max?: number;
  /** What one notch of a number scrub adds. */
  readonly step?: number;
  readonly integer?: boolean;
}

/** Radians; the apps show degrees. */
export interface AngleField extends FieldBase {
  readonly kind: 'angle';
  readonly default: number;
  readonly unit: 'rad';
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
}

export interface BooleanField extends FieldBase {
  readonly kind: 'boolean';
  readonly default: boolean;
}

export interface StringField extends FieldBase {
  readonly kind: 'string';
  readonly default: string;
  /** Name of a property of the owner that lists the texts to choose from, '' for none; any text when absent. */
  readonly choices?: string;
  /** What is typed: 'key' is the code of a key (KeyboardEvent.code), which editors take by having it pressed; any text when absent. */
  readonly input?: 'key';
}

export interface ChoiceField<Option extends string = string> extends FieldBase {
  readonly kind: 'choice';
  readonly default: Option;
  readonly options: readonly Option[];
  /** What options are shown as, where that is not their name. */
  readonly optionLabels?: { readonly [K in Option]?: string };
}

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

/** Linear sRGB primaries; each channel 0 or more, above 1 allowed. */
export interface ColourField extends FieldBase {
  readonly kind: 'colour';
  readonly default: Vector3Tuple;
}

export type AssetType = 'mesh' | 'texture' | 'material' | 'shader' | 'model' | 'script' | 'clip' | 'sound';

/** The name of an asset of the scene's AssetLibrary, or null. */
export interface AssetField extends FieldBase {
  readonly kind: 'asset';
  readonly default: string | null;
  readonly assetType: AssetType;
}

/** The id of a GameObject of the same scene, or null. */
export interface ObjectField extends FieldBase {
  readonly kind: 'object';
  readonly default: string | null;
  /** What null is shown as; 'No object' when absent. */
  readonly noneLabel?: string;
}

/** A type of fields that the engine does not know by itself. */
export interface FieldType {
  /** By which editors find a control for its fields. */
  readonly name: string;
  /** What it allows, as the end of "must be …". */
  readonly allows: string;
  /** Whether it allows a value. NaN and infinities are no values in any case. */
  check(value: FieldValue): boolean;
}

/** A field of a type of its own, with its own check. */
export interface CustomField extends FieldBase {
  readonly kind: 'custom';
  readonly type: FieldType;
  readonly default: FieldValue;
}

export type Field =
  | NumberField
  | AngleField
  | BooleanField
  | StringField
  | ChoiceField
  | Vector3Field
  | EulerField
  | ColourField
  | AssetField
  | ObjectField
  | CustomField;

export type FieldKind = Field['kind'];
export type FieldTable = Readonly<Record<string, Field>>;
export type FieldValue = number | boolean | string | null | Vector3Tuple;

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
          : F extends { kind: 'custom'; default: infer Default }
            ? Widened<Default>
            : string | null;

/** The type of the values of a custom field, by its default. */
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
