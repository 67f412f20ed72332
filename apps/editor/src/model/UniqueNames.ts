import type { GameObject } from '@farol/engine';

/** A scene, or a part of one, in which names are unique. */
interface Named {
  traverse(visit: (object: GameObject) => void): void;
}

/** Makes names that no object of a scene has: 'Box', then 'Box 2', 'Box 3'. */
export class UniqueNames {
  private readonly taken = new Set<string>();
  /** Next number to try for each numbered name that is taken. */
  private readonly next = new Map<string, number>();

  constructor(scene: Named) {
    scene.traverse(({ name }) => this.taken.add(name));
  }

  /** Reserves and returns a free name: `base`, or `base` with the first free number after it. */
  take(base: string): string {
    const name = this.taken.has(base) ? this.numbered(base) : base;
    this.taken.add(name);
    return name;
  }

  private numbered(base: string): string {
    const [, stem, digits] = /^(.*?)(?: (\d{1,9}))?$/s.exec(base)!;
    const passed: string[] = [];
    let number = Number(digits ?? 1) + 1;
    for (let name = `${stem} ${number}`; this.taken.has(name); name = `${stem} ${number}`) {
      passed.push(name);
      number = this.next.get(name) ?? number + 1;
    }
    // all numbers up to this one are taken: skipped next time
    for (const name of passed) this.next.set(name, number + 1);
    return `${stem} ${number}`;
  }
}

/** Gives objects that are added to a scene unique names; their descendants' names are unchanged. */
export function nameUniquely(scene: Named, objects: readonly GameObject[]): void {
  const names = new UniqueNames(scene);
  for (const object of objects) object.name = names.take(object.name);
}
