import { joinColour, numberDisplay, splitColour } from '@farol/editing';
import type { Scene } from '@farol/engine';
import { checkFieldValue, type Field, type FieldOwner, type FieldTable, type FieldValue } from '@farol/engine/fields';
import { z } from 'zod';
import { findObject } from './findObjects';

/** A value as an agent reads and writes it: angles in degrees, colours '#rrggbb' where a screen can show them. */
export type AgentValue = FieldValue | readonly unknown[];

const HEX = /^#([0-9a-f]{3}|[0-9a-f]{6})$/i;
const isAngle = ({ kind }: Field): boolean => kind === 'angle' || kind === 'euler';
const shortened = (value: number): number => Number(value.toPrecision(6));

/** Unit of a field as an agent writes its values; undefined for none. */
export function unitOf(field: Field): string | undefined {
  if ('unitBy' in field && field.unitBy) {
    const { field: other, units } = field.unitBy;
    const ofUnit = (unit: string): string[] => Object.keys(units).filter((value) => units[value] === unit);
    return [...new Set(Object.values(units))]
      .map((unit) => `${unit} where ${other} is ${ofUnit(unit).join(', ')}`)
      .join('; ');
  }
  return numberDisplay(field).unit;
}

/** Range of a field's numbers, in the unit of {@link unitOf}. */
export function rangeOf(field: Field): { min?: number; max?: number } {
  const { min, max } = numberDisplay(field);
  return { ...(min !== undefined && { min }), ...(max !== undefined && { max }) };
}

const within = (number: z.ZodNumber, { min, max }: { min?: number; max?: number }): z.ZodNumber => {
  const above = min === undefined ? number : number.min(min);
  return max === undefined ? above : above.max(max);
};

const triple = (number: z.ZodNumber): z.ZodArray<z.ZodNumber> => z.array(number).length(3);

function schemaOfKind(field: Field): z.ZodType {
  const isWhole = field.kind === 'number' && field.integer;
  const number = within(isWhole ? z.int() : z.number(), rangeOf(field));
  const time = z.number().min(0).max(1);
  const colour = triple(z.number().min(0));
  switch (field.kind) {
    case 'number':
    case 'angle':
      return number;
    case 'boolean':
      return z.boolean();
    case 'string':
      return z.string();
    case 'choice':
      return z.enum(field.options as [string, ...string[]]);
    case 'vector3':
    case 'euler':
      return triple(number);
    case 'colour':
      return z.union([z.string().regex(HEX), colour]);
    case 'curve':
      return z
        .array(z.tuple([time, number]))
        .min(1)
        .max(64);
    case 'gradient':
      return z
        .array(z.tuple([time, colour.nullable(), time.nullable()]))
        .min(1)
        .max(64);
    case 'asset':
    case 'object':
      return z.string().min(1).nullable();
    case 'custom':
      return z.unknown();
  }
}

function conditionOf({ visibleWhen }: Field): string {
  const parts: string[] = [];
  for (let each = visibleWhen; each; each = each.and) parts.push(`${each.field} is ${each.equals.join(' or ')}`);
  return parts.length > 0 ? `Only while ${parts.join(' and ')}.` : '';
}

/** Schema of a field's values as an agent writes them: unit and range are those of the field's own declaration. */
export function schemaOfField(field: Field): z.ZodType {
  const unit = unitOf(field);
  const more = {
    asset: () => `Name of a ${(field as { assetType?: string }).assetType}, or null.`,
    object: () => 'Name, path or id of an object, or null.',
    colour: () => "'#rrggbb', or linear [r, g, b].",
    custom: () => `Must be ${(field as { type: { allows: string } }).type.allows}.`,
  }[field.kind as string];
  const parts = [field.help, unit && `Unit: ${unit}.`, more?.(), conditionOf(field)];
  return schemaOfKind(field).describe(parts.filter(Boolean).join(' '));
}

/** Schema of all fields that an agent may set. */
export const schemaOfFields = (fields: FieldTable): z.ZodObject =>
  z.strictObject(
    Object.fromEntries(
      Object.entries(fields)
        .filter(([, { readOnly, deprecated }]) => !readOnly && !deprecated)
        .map(([name, field]) => [name, schemaOfField(field).optional().default(shownValue(field, field.default))]),
    ),
  );

/** Converts a field's value to the form that agents read. */
export function shownValue(field: Field, value: FieldValue): AgentValue {
  if (field.kind === 'colour') {
    const colour = value as readonly [number, number, number];
    const { hex, intensity } = splitColour(colour);
    return intensity === 1 ? hex : colour.map(shortened);
  }
  const { toShown } = numberDisplay(field);
  const shown = (number: number): number => shortened(toShown(number));
  if (typeof value === 'number') return shown(value);
  if (field.kind === 'vector3' || field.kind === 'euler') return (value as readonly number[]).map(shown);
  return value;
}

/** Text after "must be …" in an error: the values that a field allows, in an agent's units. */
function allowedBy(field: Field, value: unknown): string {
  const { min, max } = rangeOf(field);
  const range = [min !== undefined && `at least ${min}°`, max !== undefined && `at most ${max}°`].filter(Boolean);
  if (field.kind === 'angle') return ['an angle in °', ...range].join(', ');
  if (field.kind === 'euler') return '[x, y, z] in °';
  if (field.kind === 'colour') return "'#rrggbb', or linear [r, g, b] of at least 0";
  if (field.kind === 'object') return 'the name, path or id of an object, or null';
  return /^must be (.*), not /s.exec(checkFieldValue(field, value) ?? '')?.[1] ?? 'another value';
}

/**
 * Converts an agent's value to the field's own unit.
 * @throws Error that names owner and field, and what is allowed
 */
export function storedValue(owner: FieldOwner, name: string, value: unknown, scene: Scene): FieldValue {
  const { ownerName, fields } = owner;
  if (!Object.hasOwn(fields, name))
    throw new Error(`${ownerName} has no field “${name}”. Its fields are ${Object.keys(fields).join(', ')}.`);
  const field = fields[name];
  if (field.readOnly) throw new Error(`${ownerName}.${name} can only be read.`);
  if (!schemaOfField(field).safeParse(value).success) {
    const given = JSON.stringify(value)?.slice(0, 80);
    throw new Error(`${ownerName}.${name} must be ${allowedBy(field, value)}, not ${given}. ${field.help}`);
  }
  if (field.kind === 'colour' && typeof value === 'string') return joinColour(value, 1)!;
  if (field.kind === 'object' && typeof value === 'string') return findObject(scene, value).id;
  if (!isAngle(field)) return value as FieldValue;
  const { fromShown } = numberDisplay(field);
  if (typeof value === 'number') return fromShown(value);
  const [x, y, z] = (value as number[]).map(fromShown);
  return [x, y, z];
}
