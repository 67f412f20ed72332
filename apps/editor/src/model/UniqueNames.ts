import type { GameObject } from '@farol/engine';

/** What objects are named in: a scene, or a part of it. */
interface Named {
  traverse(visit: (object: GameObject) => void): void;
}

/** Gives names that no object of a scene has: 'Box', then 'Box 2', 'Box 3'. */
export class UniqueNames {
  private readonly taken = new Set<string>();
  /** By a numbered name that is taken: the number to try after it. */
  private readonly next = new Map<string, number>();

  /** Knows the names that there are now. */
  constructor(scene: Named) {
    scene.traverse(({ name }) => this.taken.add(name));
  }

  /** A name that is free, and is taken from now on: the one wanted, else with the first number that is free. */
  take(wanted: string): string {
    const name = this.taken.has(wanted) ? this.numbered(wanted) : wanted;
    this.taken.add(name);
    return name;
  }

  private numbered(wanted: string): string {
    const [, stem, digits] = /^(.*?)(?: (\d{1,9}))?$/s.exec(wanted)!;
    const passed: string[] = [];
    let number = Number(digits ?? 1) + 1;
    for (let name = `${stem} ${number}`; this.taken.has(name); name = `${stem} ${number}`) {
      passed.push(name);
      number = this.next.get(name) ?? number + 1;
    }
    // all up to the one that is given away are taken: nobody goes through them again
    for (const name of passed) this.next.set(name, number + 1);
    return `${stem} ${number}`;
  }
}

/** Gives objects that come to a scene names that no other one there has; all below them keep theirs. */
export function nameUniquely(scene: Named, objects: readonly GameObject[]): void {
  const names = new UniqueNames(scene);
  for (const object of objects) object.name = names.take(object.name);
}
