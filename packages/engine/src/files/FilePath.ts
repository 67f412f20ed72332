import { shortText } from '@farol/editing';

/** Path of a value in a scene file: text, or an object that makes the text on demand. */
export type PathLike = string | FilePath;

/**
 * A path in a file, such as `objects[3].components[1].values`. Its text is made for messages only: large files have
 * hundreds of thousands of paths, and few messages.
 */
export class FilePath {
  constructor(
    private readonly above: PathLike,
    private readonly key: string | number,
  ) {}

  toString(): string {
    const { key } = this;
    const above = String(this.above);
    if (typeof key === 'number') return `${above}[${key}]`;
    const name = shortText(key);
    return above ? `${above}.${name}` : name;
  }
}
