/** The part of WebGPU used here; TypeScript's library lacks it. */
interface Gpu {
  requestAdapter(): Promise<{ readonly info?: Readonly<Record<string, string>> } | null>;
}

let name: Promise<string | null> | null = null;

/** Name of the WebGPU adapter; null without one. Requested once, since browsers log each request that fails. */
export function webgpuName(): Promise<string | null> {
  name ??= ask((navigator as { gpu?: Gpu }).gpu);
  return name;
}

async function ask(gpu: Gpu | undefined): Promise<string | null> {
  const adapter = await gpu?.requestAdapter().catch(() => null);
  if (!adapter) return null;
  const { vendor, architecture, device, description } = adapter.info ?? {};
  return [vendor, architecture, device, description].filter((part) => part).join(' ') || 'a WebGPU adapter';
}
