import { t } from '../language/translate';
import { NumberSyntaxError, type Token, tokensOf } from './numberTokens';
import { isAlike, isPure, multiplyUnits, noUnit, type Unit, unitOf } from './units';

/** A number with its unit. */
export interface Quantity {
  readonly value: number;
  readonly unit: Unit;
  /** Whether the quantity is a unit without a number, such as the second in m/s. */
  readonly isBareUnit?: boolean;
}

/** Greatest nesting of brackets and signs. */
const MAXIMUM_DEPTH = 50;

const constants: Readonly<Record<string, number>> = { pi: Math.PI, π: Math.PI, tau: 2 * Math.PI };

const functions: Readonly<Record<string, (value: number) => number>> = {
  ...{ sqrt: Math.sqrt, abs: Math.abs, round: Math.round, floor: Math.floor, ceil: Math.ceil },
  ...{ sin: Math.sin, cos: Math.cos, tan: Math.tan, asin: Math.asin, acos: Math.acos, atan: Math.atan },
  ...{ exp: Math.exp, ln: Math.log, log: Math.log10 },
};
const inverses = new Set(['asin', 'acos', 'atan']);

/**
 * Parses an expression of numbers, units, π, brackets, + - * / ^ and functions of one number: 'sqrt(2)', '1/3 m', '2 m
 * + 30cm'. Adjacent numbers with units are added: '5ft 3in'.
 */
export class NumberParser {
  private readonly tokens: readonly Token[];
  private at = 0;
  private depth = 0;

  /**
   * @param units - units of the field; the first one applies to numbers without a unit
   * @param fieldUnit - the field's unit as text
   * @throws NumberSyntaxError
   */
  constructor(
    text: string,
    private readonly units: readonly Unit[],
    private readonly fieldUnit?: string,
  ) {
    this.tokens = tokensOf(text);
  }

  /** Reads the whole expression. @throws NumberSyntaxError */
  read(): Quantity {
    const value = this.sum();
    const next = this.peek();
    if (!next) return value;
    if (next.text === ')') throw new NumberSyntaxError(t('There is one “)” too many.'));
    const before = this.tokens[this.at - 1].text;
    if (next.kind === 'word') throw this.unknown(next.text);
    throw new NumberSyntaxError(
      t('Between “{before}” and “{after}” a sign such as + is missing.', { before, after: next.text }),
    );
  }

  private peek(): Token | undefined {
    return this.tokens[this.at];
  }

  private accept(...texts: string[]): string | null {
    const next = this.peek();
    if (next?.kind !== 'sign' || !texts.includes(next.text)) return null;
    this.at++;
    return next.text;
  }

  private sum(): Quantity {
    let left = this.product();
    for (;;) {
      const sign = this.accept('+', '-');
      // adjacent quantities are added, as in '5ft 3in'
      if (!sign && !(this.peek()?.kind === 'number' && !isPure(left.unit))) return left;
      left = this.add(left, this.product(), sign === '-' ? -1 : 1);
    }
  }

  private add(a: Quantity, b: Quantity, sign: number): Quantity {
    const [first, second] = [this.withUnit(a, b), this.withUnit(b, a)];
    if (!isAlike(first.unit, second.unit)) {
      throw new NumberSyntaxError(t('What is added has to be in units of one kind.'));
    }
    const { unit } = first;
    return { value: first.value + sign * second.value * (second.unit.factor / unit.factor), unit };
  }

  /** Gives a number without a unit the field's unit, when the other operand has a unit. */
  private withUnit(quantity: Quantity, other: Quantity): Quantity {
    if (!isPure(quantity.unit) || isPure(other.unit)) return quantity;
    const unit = this.units.find((each) => isAlike(each, other.unit));
    return unit ? { value: quantity.value * quantity.unit.factor, unit } : quantity;
  }

  private product(): Quantity {
    let left = this.signed();
    for (;;) {
      const sign = this.accept('*', '/');
      if (!sign) return left;
      const right = this.signed(true);
      left = sign === '*' ? this.multiply(left, right) : this.divide(left, right);
    }
  }

  private multiply(a: Quantity, b: Quantity): Quantity {
    return { value: a.value * b.value, unit: multiplyUnits(a.unit, b.unit, 1) };
  }

  private divide(a: Quantity, b: Quantity): Quantity {
    if (b.value === 0) throw new NumberSyntaxError(t('A number cannot be divided by 0.'));
    const unit = multiplyUnits(a.unit, b.unit, -1);
    // 1/3 m: the unit applies to the whole fraction
    const ofWhole =
      isPure(a.unit) && !isPure(b.unit) && !b.isBareUnit && !this.units.some((each) => isAlike(each, unit));
    if (!ofWhole) return { value: a.value / b.value, unit };
    return { value: (a.value * a.unit.factor) / b.value, unit: b.unit };
  }

  private signed(mayBeUnit = false): Quantity {
    const sign = this.accept('-', '+');
    if (!sign) return this.power(mayBeUnit);
    const { value, unit } = this.deeper(() => this.signed());
    return { value: sign === '-' ? -value : value, unit };
  }

  private power(mayBeUnit: boolean): Quantity {
    const base = this.unitAfter(this.operand(mayBeUnit));
    if (!this.accept('^', '**')) return base;
    const exponent = this.deeper(() => this.signed());
    if (!isPure(base.unit) || !isPure(exponent.unit)) {
      throw new NumberSyntaxError(t('A power is of numbers without units.'));
    }
    return { value: (base.value * base.unit.factor) ** (exponent.value * exponent.unit.factor), unit: noUnit };
  }

  /** Parses units after a number, and constants or brackets, which multiply: 2pi, 3(1+1). */
  private unitAfter(operand: Quantity): Quantity {
    let result = operand;
    for (;;) {
      const next = this.peek();
      if (!next || result.isBareUnit) return result;
      const unit = next.kind === 'word' && !this.isFunction() ? unitOf(next.text, this.fieldUnit) : null;
      if (unit) {
        if (!isPure(result.unit) || (result.unit !== noUnit && result.unit.factor !== 1)) return result;
        this.at++;
        result = { value: result.value, unit: multiplyUnits(noUnit, unit, this.unitPower()) };
      } else if ((next.kind === 'word' && this.isKnown(next.text)) || next.text === '(') {
        result = this.multiply(result, this.operand(false));
      } else return result;
    }
  }

  private unitPower(): number {
    if (this.accept('²')) return 2;
    return this.accept('³') ? 3 : 1;
  }

  private isFunction(): boolean {
    const next = this.tokens[this.at + 1];
    return next?.kind === 'sign' && next.text === '(' && this.isKnown(this.tokens[this.at].text);
  }

  private isKnown(word: string): boolean {
    const name = word.toLowerCase();
    return Object.hasOwn(constants, name) || Object.hasOwn(functions, name);
  }

  private operand(mayBeUnit: boolean): Quantity {
    const next = this.peek();
    const before = this.tokens[this.at - 1]?.text;
    if (!next) {
      if (before === undefined) throw new NumberSyntaxError(t('A number is missing.'), true);
      throw new NumberSyntaxError(t('Something is missing after “{text}”.', { text: before }), true);
    }
    this.at++;
    if (next.kind === 'number') return { value: next.value, unit: noUnit };
    if (next.text === '(') return this.deeper(() => this.bracket());
    if (next.kind === 'sign') {
      if (before === undefined)
        throw new NumberSyntaxError(t('A number cannot begin with “{text}”.', { text: next.text }));
      throw new NumberSyntaxError(
        t('Between “{before}” and “{after}” a number is missing.', { before, after: next.text }),
      );
    }
    return this.word(next.text, mayBeUnit);
  }

  private word(text: string, mayBeUnit: boolean): Quantity {
    const name = text.toLowerCase();
    if (Object.hasOwn(constants, name)) return { value: constants[name], unit: noUnit };
    const unit = mayBeUnit ? unitOf(text, this.fieldUnit) : null;
    if (unit) return { value: 1, unit: multiplyUnits(noUnit, unit, this.unitPower()), isBareUnit: true };
    if (!Object.hasOwn(functions, name)) throw this.unknown(text);
    if (!this.accept('(')) {
      throw new NumberSyntaxError(t('After “{text}” a bracket is missing: {text}(…).', { text: name }), !this.peek());
    }
    const { value, unit: of } = this.deeper(() => this.bracket());
    const { [name]: calculate } = functions;
    if (/^(sin|cos|tan)$/.test(name) && of.powers.rad === 1)
      return { value: calculate(value * of.factor), unit: noUnit };
    if (/^(abs|round|floor|ceil)$/.test(name)) return { value: calculate(value), unit: of };
    if (!isPure(of)) throw new NumberSyntaxError(t('“{text}” is of a number without a unit.', { text: name }));
    const unitOfResult =
      inverses.has(name) && this.units[0].powers.rad === 1 ? { factor: 1, powers: { rad: 1 } } : noUnit;
    return { value: calculate(value * of.factor), unit: unitOfResult };
  }

  private bracket(): Quantity {
    const { value, unit } = this.sum();
    if (this.accept(')')) return { value, unit };
    const next = this.peek();
    if (!next) throw new NumberSyntaxError(t('A “)” is missing.'), true);
    throw new NumberSyntaxError(t('Before “{text}” a “)” is missing.', { text: next.text }));
  }

  private unknown(word: string): NumberSyntaxError {
    if (this.isKnown(word))
      return new NumberSyntaxError(t('Before “{text}” a sign such as + is missing.', { text: word }));
    if (unitOf(word, this.fieldUnit))
      return new NumberSyntaxError(t('Before “{text}” a number is missing.', { text: word }));
    const mayGoOn = this.at >= this.tokens.length;
    return new NumberSyntaxError(t('“{text}” is neither a unit nor a function.', { text: word }), mayGoOn);
  }

  private deeper(read: () => Quantity): Quantity {
    if (++this.depth > MAXIMUM_DEPTH) throw new NumberSyntaxError(t('There are too many brackets.'));
    const result = read();
    this.depth--;
    return result;
  }
}
