/** A piece of shader source: a header of declarations and functions, and a piece of main(). Thesis 3.1.2. */
export interface MicroShader {
  readonly name: string;
  readonly header: string;
  readonly main: string;
  readonly dependencies: readonly string[];
}
