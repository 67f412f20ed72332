import { unknownName } from './errors';
import type { Lazy } from '../frame/Lazy';
import { gridCode, tileCode } from '../techniques/techniqueCode';
import type { Pass } from '../frame/Pass';
import { validatePasses } from '../frame/validatePasses';
import { techniques } from '../techniques';
import type { MemoryInfo } from './FarolInfo';
import type { MicroShaderRegistry } from '../microshaders';
import { addMicroShaders } from '../microshaders/addMicroShaders';
import type { Technique } from '../frame/Technique';

/** Above this many lights, a frame by a loop over all of them takes longer than compiling another technique. */
export const MOST_IN_A_LOOP = 128;

/** The techniques of one renderer, and the passes of those used so far. */
export class TechniqueSet {
  /** Techniques by name: the built-in ones, and those that were added. */
  readonly known: Record<string, Technique> = { ...techniques };
  private readonly lists = new Map<string, Pass[]>();

  constructor(private readonly microshaders: MicroShaderRegistry) {}

  /** Adds a technique. @throws Error when a technique has that name already */
  add(name: string, technique: Technique): void {
    if (Object.hasOwn(this.known, name)) throw new Error(`Farol: technique "${name}" exists; choose another name.`);
    this.known[name] = technique;
  }

  /** Removes an added technique and frees its passes. @throws Error when none was added by that name */
  remove(name: string): void {
    if (!Object.hasOwn(this.known, name) || Object.hasOwn(techniques, name))
      throw new Error(`Farol: technique "${name}" was not added; only added ones can be removed.`);
    for (const pass of this.lists.get(name) ?? []) pass.dispose();
    this.lists.delete(name);
    delete this.known[name];
  }

  /** Technique of a name. @throws Error when the name is unknown */
  get(name: string): Technique {
    if (!Object.hasOwn(this.known, name)) throw unknownName('technique', name, Object.keys(this.known));
    return this.known[name];
  }

  /** Late code that a technique needs: its own, or that of its light order. */
  codeOf(name: string): Lazy<object> | undefined {
    const { lazy, lightOrder } = this.known[name];
    return lazy ?? (lightOrder === 'by-grid' ? gridCode : lightOrder === 'by-depth' ? tileCode : undefined);
  }

  /** @throws Error when a pass reads a resource that no earlier pass writes, or the technique's code is not loaded */
  passesOf(name: string): Pass[] {
    let passes = this.lists.get(name);
    if (passes === undefined) {
      passes = this.known[name].passes();
      validatePasses(name, passes);
      for (const { microShaders = {} } of passes) addMicroShaders(this.microshaders, `technique ${name}`, microShaders);
      this.lists.set(name, passes);
    }
    return passes;
  }

  /** Whether a technique draws the depth of opaque items into the target before it shades them. */
  drawsDepthFirst(name: string): boolean {
    return this.passesOf(name).some(({ writes }) => writes.includes('scene-depth') && writes.includes('target'));
  }

  /** Whether a technique shows the counts of the view 'overdraw' itself. */
  showsOverdraw(name: string): boolean {
    return this.passesOf(name).some(({ reads }) => reads.includes('overdraw'));
  }

  /** Adds the bytes of all passes to the kinds of memory that they write. */
  count(memory: MemoryInfo): void {
    memory.gbuffer = memory.lists = memory.targets = 0;
    for (const passes of this.lists.values()) {
      for (const { writes, bytes } of passes)
        memory[writes.includes('gbuffer') ? 'gbuffer' : writes.includes('light-lists') ? 'lists' : 'targets'] += bytes;
    }
  }

  dispose(): void {
    for (const passes of this.lists.values()) for (const pass of passes) pass.dispose();
    this.lists.clear();
  }
}
