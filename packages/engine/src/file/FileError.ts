/** One thing that is wrong with a file. */
export interface FileProblem {
  /** Where in the file: 'objects[3].components[1].values.roughness'; '' for the file as a whole. */
  readonly path: string;
  /** What is wrong, and the mend. */
  readonly problem: string;
}

const SHOWN = 20;

/** A file that cannot be loaded, with everything that is wrong with it. Nothing of it has been loaded. */
export class FileError extends Error {
  constructor(
    readonly problems: readonly FileProblem[],
    options?: ErrorOptions,
  ) {
    const lines = problems.slice(0, SHOWN).map(({ path, problem }) => (path ? `${path} ${problem}` : problem));
    if (problems.length > SHOWN) lines.push(`… and ${problems.length - SHOWN} more`);
    super(`The scene file cannot be loaded:\n${lines.join('\n')}`, options);
    this.name = 'FileError';
  }
}
