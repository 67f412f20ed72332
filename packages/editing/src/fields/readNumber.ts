import { t } from '../language/translate';
import { NumberParser, type Quantity } from './NumberParser';
import { NumberSyntaxError } from './numberTokens';
import { isAlike, isPure, type Unit, unitsOfField } from './units';

/** Reason why a typed text is no number. */
export interface NumberProblem {
  /** The problem as one short sentence. */
  readonly problem: string;
  /** Whether further typing may make the text a number, as with '1/'. */
  readonly isIncomplete: boolean;
}

/** Meaning of a typed text: a number, or a change of the present one. */
export interface NumberEdit {
  readonly problem: null;
  /** Whether the result depends on the present value, as with '+=0.5'. */
  readonly isRelative: boolean;
  /** New value from the present one; both in the field's unit. Finite for finite values. */
  valueFor(before: number): number;
}

/** Range and unit of a number as displayed. */
export interface NumberRange {
  /** Unit of numbers typed without a unit. */
  readonly unit?: string;
  readonly min?: number;
  readonly max?: number;
}

const RELATIVE = /^([-+*/])=(.*)$/s;
const MAXIMUM_LENGTH = 200;
const SIGNS: Readonly<Record<string, string>> = { '−': '-', '–': '-', '×': '*', '·': '*', '÷': '/' };

const finite = (value: number): number => Math.min(Math.max(value, -Number.MAX_VALUE), Number.MAX_VALUE);

/** Rounds to 15 digits, to remove rounding errors of arithmetic: 0.1 + 0.2 is 0.3. */
const tidied = (value: number): number => Number(value.toPrecision(15));

/** Converts a quantity to the field's unit. @throws NumberSyntaxError for an incompatible unit */
function inUnitOf({ value, unit }: Quantity, units: readonly Unit[], fieldUnit: string | undefined): number {
  const own = units.find((each) => isAlike(each, unit));
  if (own) return value * (unit.factor / own.factor);
  // a number without a unit is in the field's unit
  if (isPure(unit)) return value * unit.factor;
  if (!fieldUnit) throw new NumberSyntaxError(t('This number has no unit: leave the unit out.'));
  throw new NumberSyntaxError(t('The unit does not fit: this number is in {unit}.', { unit: fieldUnit }));
}

/**
 * Parses the text typed into a number field: a number with a decimal point or comma, an expression, units, or a change
 * by `+=`, `-=`, `*=` and `/=`. See {@link NumberParser} for expressions. Never throws.
 * @param unit - unit of the field, such as 'm/s' or '°', which applies to numbers without a unit
 */
export function readNumber(text: string, unit?: string): NumberEdit | NumberProblem {
  try {
    if (text.length > MAXIMUM_LENGTH) throw new NumberSyntaxError(t('This is too long for a number.'));
    const plain = text.replaceAll(/[−–×·÷]/g, (sign) => SIGNS[sign]).trim();
    const [, operator, operand] = RELATIVE.exec(plain) ?? [];
    return operator ? relativeEdit(operator, operand, unit) : absoluteEdit(plain, unit);
  } catch (error) {
    if (!(error instanceof NumberSyntaxError)) throw error;
    return { problem: error.message, isIncomplete: error.isIncomplete };
  }
}

function absoluteEdit(text: string, unit: string | undefined): NumberEdit {
  const units = unitsOfField(unit);
  const value = checked(inUnitOf(new NumberParser(text, units, unit).read(), units, unit), text);
  return { problem: null, isRelative: false, valueFor: () => value };
}

function relativeEdit(operator: string, text: string, unit: string | undefined): NumberEdit {
  const units = unitsOfField(unit);
  const quantity = new NumberParser(text, units, unit).read();
  if (operator === '*' || operator === '/') {
    if (!isPure(quantity.unit)) throw new NumberSyntaxError(t('A factor has no unit: leave the unit out.'));
    const factor = checked(quantity.value * quantity.unit.factor, text);
    if (operator === '/' && factor === 0) throw new NumberSyntaxError(t('A number cannot be divided by 0.'));
    return {
      ...{ problem: null, isRelative: true },
      valueFor: (before) => finite(tidied(operator === '*' ? before * factor : before / factor)),
    };
  }
  if (isPure(quantity.unit) && quantity.unit.factor !== 1 && unit !== '%') {
    throw new NumberSyntaxError(t('To change a number by a part of it, write *= and a factor, such as *=1.1.'));
  }
  const amount = checked(inUnitOf(quantity, units, unit), text) * (operator === '-' ? -1 : 1);
  return { problem: null, isRelative: true, valueFor: (before) => finite(tidied(before + amount)) };
}

/** Returns the value, rounded. @throws NumberSyntaxError when `value` is not finite */
function checked(value: number, text: string): number {
  if (!Number.isFinite(value)) {
    throw new NumberSyntaxError(
      Number.isNaN(value) ? t('There is no such number.') : t('This is larger than a number can be.'),
    );
  }
  // a number, as opposed to an expression, keeps all typed digits
  return /^[-+]?[\d.,]+(e[-+]?\d+)?$/i.test(text) ? value : tidied(value);
}

/**
 * Parses the text typed into a field with a range. A number outside the range is a problem; a relative change (`+=`
 * etc.) is clamped to the range, for each object.
 */
export function readNumberInRange(text: string, range: NumberRange): NumberEdit | NumberProblem {
  const { unit, min = -Infinity, max = Infinity } = range;
  const read = readNumber(text, unit);
  if (read.problem !== null) return read;
  const { isRelative } = read;
  if (isRelative) {
    return { problem: null, isRelative, valueFor: (before) => Math.min(Math.max(read.valueFor(before), min), max) };
  }
  const value = read.valueFor(0);
  if (value >= min && value <= max) return read;
  const words = { min: shortest(min), max: shortest(max), unit: unit === '°' ? unit : unit ? ` ${unit}` : '' };
  if (min === -Infinity) return { problem: t('It must be at most {max}{unit}.', words), isIncomplete: false };
  if (max === Infinity) return { problem: t('It must be at least {min}{unit}.', words), isIncomplete: false };
  return { problem: t('It must be from {min} to {max}{unit}.', words), isIncomplete: false };
}

const shortest = (value: number): string => String(Number(value.toPrecision(6)));
