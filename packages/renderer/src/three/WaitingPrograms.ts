import type { WebGLRenderer } from 'three';

/** Parts of three's WebGLProgram that Farol uses. */
export interface Program {
  /** The WebGL program; undefined once deleted. */
  readonly program?: WebGLProgram;
  /** three's cached uniforms; the first call waits for the link, as that of `getAttributes` does. */
  getUniforms: () => unknown;
  getAttributes(): unknown;
  isReady(): boolean;
}

/** three's list `WebGLRenderer.info.programs`, to which three pushes the programs that it compiles. */
export type ProgramList = Program[];

/** Programs whose compilation was started and not yet waited for. */
export class WaitingPrograms {
  private readonly programs: Program[] = [];
  private readonly getters: Program['getUniforms'][] = [];

  get length(): number {
    return this.programs.length;
  }

  /** Adds a program, blocked until `unblock`. */
  add(program: Program, stop: () => never): void {
    this.programs.push(program);
    this.getters.push(program.getUniforms);
    program.getUniforms = stop;
  }

  /** Makes three's calls for the uniforms of waiting programs throw, since they would wait for the link. */
  block(stop: () => never): void {
    for (const program of this.programs) program.getUniforms = stop;
  }

  unblock(): void {
    for (let i = 0; i < this.programs.length; i++) this.programs[i].getUniforms = this.getters[i];
  }

  /** Reads uniforms and attributes of the first waiting program, if it is linked, as its first draw would. */
  finishOne(): void {
    const { programs, getters } = this;
    if (programs.length === 0) return;
    const [first] = programs;
    const deleted = first.program === undefined;
    if (!deleted && !first.isReady()) return;
    programs.shift();
    getters.shift();
    if (deleted) return;
    first.getUniforms();
    first.getAttributes();
  }
}

const lists = new WeakMap<ProgramList, WaitingPrograms>();

/** Compiling programs of one WebGLRenderer; replaced when its context is lost. */
export function waitingPrograms(programs: ProgramList): WaitingPrograms {
  let waiting = lists.get(programs);
  if (waiting === undefined) lists.set(programs, (waiting = new WaitingPrograms()));
  return waiting;
}

/** three's list of compiled programs; replaced when a lost context is restored. */
export function programsOf(webgl: WebGLRenderer): ProgramList {
  return webgl.info.programs as unknown as ProgramList;
}

/** Calls a function with each program that three starts to compile. @returns function that stops the calls */
export function watchNewPrograms(programs: ProgramList, tell: (program: Program) => void): () => void {
  programs.push = (program: Program) => {
    tell(program);
    return Array.prototype.push.call(programs, program);
  };
  return () => void Reflect.deleteProperty(programs, 'push');
}

/** Ends three's draws by an exception where they would first use their program. @returns function that restores normal draws */
export function stopUsingPrograms({ state }: WebGLRenderer, stop: () => never): () => void {
  const { useProgram } = state;
  state.useProgram = stop;
  return () => void (state.useProgram = useProgram);
}
