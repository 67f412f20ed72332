/** One message of a shader compiler, with the microshader and line that caused the message. */
export interface MicroShaderCompileEntry {
  /** Name of the chunk, `three/…` for one of three's; null outside of chunks. */
  readonly chunk: string | null;
  /** Line in the chunk's file, or in the whole source when there is no chunk; from 1, 0 if unknown. */
  readonly line: number;
  readonly message: string;
  /** Text of the line, trimmed. */
  readonly text: string;
}

/** Matches lines of logs: `ERROR: 0:12: …` (ANGLE), `0:12(5): error: …` (Mesa), `0(12) : error C0000: …` (NVIDIA). */
const LOG_LINE = /^(?:ERROR|WARNING)?[: ]*\d+(?::(\d+)(?:\(\d+\))?|\((\d+)\)) *: *(.*)$/;
const FRAME = /^\/\/ <(\/?)([^>]+)>(?: (\d+))?$/;

/**
 * Maps each line number of a driver's log to chunk and line, by the frames of `MicroShaderRegistry.header` and `compose`.
 * @param log - result of `getShaderInfoLog`
 * @param source - source given to the driver; may have other text around the composed one
 */
export function explainCompileError(log: string, source: string): MicroShaderCompileEntry[] {
  const lines = source.split('\n');
  const entries: MicroShaderCompileEntry[] = [];
  for (const raw of log.split('\n')) {
    const message = raw.replaceAll('\0', '').trim();
    if (message === '') continue;
    const found = LOG_LINE.exec(message);
    if (found === null) entries.push({ chunk: null, line: 0, message, text: '' });
    else entries.push({ ...placeOf(Number(found[1] ?? found[2]), lines), message: found[3] });
  }
  return entries;
}

function placeOf(number: number, lines: readonly string[]): Omit<MicroShaderCompileEntry, 'message'> {
  const text = (lines[number - 1] ?? '').trim();
  for (let i = Math.min(number, lines.length) - 1; i >= 0; i--) {
    const frame = FRAME.exec(lines[i]);
    if (frame === null) continue;
    if (frame[1] === '/') break;
    return { chunk: frame[2], line: Number(frame[3] ?? 1) + number - 2 - i, text };
  }
  return { chunk: null, line: number, text };
}
