import { shortText } from '@farol/editing';

/** One problem of a file. */
export interface FileProblem {
  /** Place in the file: 'objects[3].components[1].values.roughness'; '' for the file as a whole. */
  readonly path: string;
  /** The problem with its remedy, as a sentence. */
  readonly problem: string;
}

/** Options of the constructor of FileError. */
export interface FileErrorOptions extends ErrorOptions {
  /** Number of further problems that the list omits; 0 when absent. */
  more?: number;
}

/** Maximum length (characters) of the message, of one problem, and of one path. */
const MESSAGE = 1800;
const PROBLEM = 400;
const PATH = 160;

/**
 * Error of a file that cannot be loaded, with its problems; nothing of the file has been loaded. The message has fewer
 * than 2,000 characters, each problem 400 at most.
 */
export class FileError extends Error {
  readonly problems: readonly FileProblem[];

  constructor(problems: readonly FileProblem[], options: FileErrorOptions = {}) {
    const short = problems.map(({ path, problem }) => ({
      path: shortText(path, PATH),
      problem: shortText(problem, PROBLEM),
    }));
    const lines: string[] = [];
    let length = 0;
    for (const { path, problem } of short) {
      const line = path ? `${path} ${problem}` : problem;
      length += line.length + 1;
      if (lines.length > 0 && length > MESSAGE) break;
      lines.push(line);
    }
    const more = short.length - lines.length + (options.more ?? 0);
    if (more > 0) lines.push(`… and ${more} more`);
    super(`The scene file cannot be loaded:\n${lines.join('\n')}`, options);
    this.name = 'FileError';
    this.problems = short;
  }
}
