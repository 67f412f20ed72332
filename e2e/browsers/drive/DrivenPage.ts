import { type ChildProcess, spawn } from 'node:child_process';

/** One action of an input device, as WebDriver has it. @see https://www.w3.org/TR/webdriver2/#actions */
export type InputAction =
  | { readonly type: 'keyDown' | 'keyUp'; readonly value: string }
  | { readonly type: 'pointerMove'; readonly x: number; readonly y: number; readonly duration?: number }
  | { readonly type: 'pointerDown' | 'pointerUp'; readonly button: number }
  | {
      readonly type: 'scroll';
      readonly x: number;
      readonly y: number;
      readonly deltaX: number;
      readonly deltaY: number;
    };

export interface InputSource {
  readonly type: 'key' | 'pointer' | 'wheel';
  readonly id: string;
  readonly actions: readonly InputAction[];
}

/** A window of a browser that is driven by WebDriver: classic or BiDi. */
export interface DrivenPage {
  /** Name and version of the browser. */
  readonly browser: string;
  open(url: string): Promise<void>;
  /** Calls a function of the page, as text with its argument as JSON; gives JSON. Rejects with the message of the page. */
  call(functionText: string, argument: string): Promise<string>;
  perform(sources: readonly InputSource[]): Promise<void>;
  /** PNG, in base64. */
  screenshot(): Promise<string>;
  close(): Promise<void>;
}

/** Size of the page (CSS pixels). */
export const PAGE = { width: 900, height: 640 };

/**
 * Waits until a process has written a line that matches.
 *
 * @throws Error when it ends before
 */
export function lineOf(child: ChildProcess, stream: NodeJS.ReadableStream, pattern: RegExp): Promise<RegExpExecArray> {
  return new Promise((resolve, reject) => {
    let text = '';
    stream.on('data', (part: Buffer) => {
      text += part.toString();
      const match = pattern.exec(text);
      if (match) resolve(match);
    });
    child.once('error', reject);
    child.once('exit', () => reject(new Error(`${child.spawnfile} ended without a line like ${pattern}: ${text}`)));
  });
}

/** The processes of a browser, and the environment that it starts in. */
export interface Surroundings {
  readonly env: NodeJS.ProcessEnv;
  readonly children: ChildProcess[];
}

/**
 * Mesa's software rasteriser, unless FAROL_GPU is set, and a screen in memory.
 *
 * @param xvfb - path of the program that makes one; null takes the screen that is there
 */
export async function startSurroundings(xvfb: string | null): Promise<Surroundings> {
  const env = { ...process.env, ...(process.env.FAROL_GPU ? {} : { LIBGL_ALWAYS_SOFTWARE: '1' }) };
  if (!xvfb) return { env, children: [] };
  const screen = spawn(xvfb, ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const [, display] = await lineOf(screen, screen.stdio[3] as NodeJS.ReadableStream, /(\d+)\n/);
  return { env: { ...env, DISPLAY: `:${display}` }, children: [screen] };
}

/** Ends a process, and waits until it has. */
function end(child: ChildProcess): Promise<void> {
  return new Promise((resolve) => {
    if (child.exitCode !== null || child.signalCode !== null) return resolve();
    child.once('exit', () => resolve());
    child.kill();
  });
}

/** Ends the last started first. */
export async function endAll(children: readonly ChildProcess[]): Promise<void> {
  for (const child of children.toReversed()) await end(child);
}
