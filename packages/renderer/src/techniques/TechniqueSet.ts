import { unknownName } from '../errors';
import type { Pass } from '../frame/Pass';
import { validatePasses } from '../frame/validatePasses';
import { techniques } from '.';
import type { Technique, TechniqueContext } from './Technique';

/** The techniques of one renderer, and the passes of those that it has drawn by. */
export class TechniqueSet {
  /** By name: the built-in ones, and those that were added. */
  readonly known: Record<string, Technique> = { ...techniques };
  private readonly lists = new Map<string, Pass[]>();

  constructor(private readonly context: TechniqueContext) {}

  /** @throws Error when there is one of that name */
  add(name: string, technique: Technique): void {
    if (Object.hasOwn(this.known, name)) throw new Error(`Farol: there is a technique "${name}"; choose another name.`);
    this.known[name] = technique;
  }

  /** @throws Error when there is none of that name */
  get(name: string): Technique {
    if (!Object.hasOwn(this.known, name)) throw unknownName('technique', name, Object.keys(this.known));
    return this.known[name];
  }

  /** @throws Error when a pass reads what none before it writes */
  passesOf(name: string): Pass[] {
    let passes = this.lists.get(name);
    if (passes === undefined) {
      passes = this.known[name].passes(this.context);
      validatePasses(name, passes);
      this.lists.set(name, passes);
    }
    return passes;
  }

  hasPass(name: string, pass: string): boolean {
    return this.passesOf(name).some((each) => each.name === pass);
  }

  /** Of the targets of all passes. */
  get bytes(): number {
    let bytes = 0;
    for (const passes of this.lists.values()) for (const pass of passes) bytes += pass.bytes;
    return bytes;
  }

  dispose(): void {
    for (const passes of this.lists.values()) for (const pass of passes) pass.dispose();
    this.lists.clear();
  }
}
