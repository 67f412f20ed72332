import { formatCount, t, textLocale } from '@farol/editing';

/** A number with at most `digits` significant digits and thousands separators: `0.123`, `1.2`, `12,300`. */
export function formatNumber(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return '–';
  if (Math.abs(value) >= Math.min(1000, 10 ** (digits - 1))) return formatCount(value);
  return String(Number(value.toPrecision(digits)));
}

/** A time as `0.12 ms` or `12.3 ms`; as `12.3 s` from ten seconds up. */
export function formatMs(ms: number): string {
  return ms >= 10_000 ? `${formatNumber(ms / 1000)} s` : `${formatNumber(ms)} ms`;
}

const dateFormat = (): Intl.DateTimeFormat =>
  new Intl.DateTimeFormat(textLocale(), { dateStyle: 'medium', timeStyle: 'short' });

/** A date in the local time zone, as `Nov 22, 2026, 6:11 PM`; other text is returned unchanged. */
export function formatDate(text: string): string {
  const date = new Date(text);
  return Number.isNaN(date.getTime()) ? text : dateFormat().format(date);
}

/** Bytes, as `640 B`, `1.2 kB`, `35 MB`, `1.25 GB`. */
export function formatBytes(bytes: number): string {
  if (bytes < 1000) return `${formatNumber(bytes)} B`;
  if (bytes < 1e6) return `${formatNumber(bytes / 1000)} kB`;
  return bytes < 1e9 ? `${formatNumber(bytes / 1e6)} MB` : `${formatNumber(bytes / 1e9)} GB`;
}

/** A factor as `4.1 times`, `1.15 times`. */
export function formatFactor(factor: number): string {
  return t('{factor} times', { factor: formatNumber(factor, factor < 2 ? 3 : 2) });
}

/** A share as `12%`, `0.4%`, `−3%`. */
export function formatPercent(share: number): string {
  const percent = share * 100;
  const text = formatNumber(Math.abs(percent), Math.abs(percent) < 10 ? 2 : 3);
  return `${percent < 0 && text !== '0' ? '−' : ''}${text}%`;
}

/** Items as a list within a sentence: `a`, `a and b`, `a, b and c`. */
export function listOf(items: readonly string[]): string {
  return items.length < 2
    ? (items[0] ?? '')
    : t('{list} and {last}', { list: items.slice(0, -1).join(', '), last: items.at(-1)! });
}
