import { type GeneratorValue, type Arbitrary, nat, noBias } from 'fast-check';

/** Whole numbers from 0 to below `count`, each as likely. */
const below = (count: number): Arbitrary<number> => noBias(nat({ max: count - 1 }));

/** Choices that fast-check draws, and makes smaller once a case fails: numbers become 0, choices the first of their list. */
export class FuzzRandom {
  constructor(private readonly draw: GeneratorValue) {}

  /** A number from 0 to below 1. */
  readonly next = (): number => this.below(2 ** 31) / 2 ** 31;

  /** A whole number from 0 to below `count`. */
  below(count: number): number {
    return this.draw(below, count);
  }

  /** True once in `times`. */
  once(times: number): boolean {
    return this.below(times) === times - 1;
  }

  of<T>(list: readonly T[]): T {
    return list[this.below(list.length)];
  }
}
