import type { Command } from '@farol/editing';
import type { AssetLibrary } from '@farol/engine';

/** Adds a folder of assets, or removes an empty one. */
export class SetFolder implements Command {
  /** Whether the folder existed before the first `do`; null before that. */
  private wasThere: boolean | null = null;

  constructor(
    readonly label: string,
    private readonly assets: AssetLibrary,
    private readonly path: string,
    private readonly isThere: boolean,
  ) {}

  get isEmpty(): boolean {
    return (this.wasThere ?? this.assets.folders.includes(this.path)) === this.isThere;
  }

  do(): void {
    this.wasThere ??= this.assets.folders.includes(this.path);
    this.assets.setFolder(this.path, this.isThere);
  }

  undo(): void {
    this.assets.setFolder(this.path, this.wasThere!);
  }
}
