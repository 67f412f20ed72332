/** A part of the package in files of its own, fetched when it is first needed; shared by all renderers of a page. */
export class LateCode<Code> {
  /** Null until it is there. */
  code: Code | null = null;
  private asked = false;

  /** @param missing what to tell when it cannot be fetched: what is missing, and what happens instead */
  constructor(
    private readonly fetch: () => Promise<Code>,
    private readonly missing: string,
  ) {}

  /** @throws Error when it cannot be fetched */
  async load(): Promise<Code> {
    return (this.code ??= await this.fetch());
  }

  /** Has it fetched, once. A failure is told on the console. */
  ask(): void {
    if (this.asked) return;
    this.asked = true;
    this.load().catch((error: unknown) =>
      console.error(`Farol: ${this.missing} (${String(error)}). Serve the files of @farol/renderer together.`),
    );
  }
}
