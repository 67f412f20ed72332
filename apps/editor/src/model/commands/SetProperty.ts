import { type Command, currentOf } from '@farol/editing';

/** Sets a plain property of all targets, such as `name` of GameObjects or `enabled` of components. */
export class SetProperty<K extends string, V> implements Command {
  /** Values before the first `do`. */
  private before: readonly V[] | null = null;

  constructor(
    readonly label: string,
    private readonly targets: readonly { [P in K]: V }[],
    private readonly property: K,
    private readonly value: V,
  ) {}

  get isEmpty(): boolean {
    return this.values().every((value) => value === this.value);
  }

  do(): void {
    this.before = this.values();
    for (const target of this.targets) currentOf(target)[this.property] = this.value;
  }

  undo(): void {
    this.targets.forEach((target, i) => {
      currentOf(target)[this.property] = this.before![i];
    });
  }

  private values(): readonly V[] {
    return this.before ?? this.targets.map((target) => currentOf(target)[this.property]);
  }
}
