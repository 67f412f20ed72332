/** A figure with three significant digits, none lost before the point: `0.042`, `1.25`, `16.7`, `1,240`. */
export function formatNumber(value: number): string {
  const size = Math.abs(value);
  if (size === 0) return '0';
  if (size >= 100) return Math.round(value).toLocaleString('en');
  if (size < 0.001) return '< 0.001';
  return value.toLocaleString('en', { maximumSignificantDigits: size < 0.1 ? 2 : 3 });
}

/** Bytes in the unit that fits: `820 B`, `1.5 kB`, `48.2 MB`. */
export function formatBytes(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  if (bytes < 1e6) return `${formatNumber(bytes / 1e3)} kB`;
  return bytes < 1e9 ? `${formatNumber(bytes / 1e6)} MB` : `${formatNumber(bytes / 1e9)} GB`;
}
