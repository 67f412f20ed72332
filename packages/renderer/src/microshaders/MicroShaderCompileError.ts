import { explainCompileError, type MicroShaderCompileEntry } from './explainCompileError';

/** Error for a shader that the driver refused, with the driver's messages by microshader and line. */
export class MicroShaderCompileError extends Error {
  override readonly name = 'MicroShaderCompileError';
  readonly entries: readonly MicroShaderCompileEntry[];

  /**
   * @param shader - name of the shader
   * @param stage - refused stage, or 'link'
   * @param log - messages of the driver
   * @param source - source given to the driver; '' for 'link'
   */
  constructor(
    readonly shader: string,
    readonly stage: 'vertex' | 'fragment' | 'link',
    log: string,
    source: string,
  ) {
    const entries = explainCompileError(log, source);
    const what = entries.map(
      ({ chunk, line, message, text }) =>
        `${chunk === null ? (line > 0 ? `line ${line}: ` : '') : `microshader "${chunk}", line ${line}: `}${message}` +
        (text === '' ? '' : `\n    ${text}`),
    );
    super(`Shader "${shader}" (${stage}) does not compile:\n  ${what.join('\n  ') || 'the driver does not say why'}`);
    this.entries = entries;
  }
}
