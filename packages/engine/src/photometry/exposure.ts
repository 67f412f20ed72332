/**
 * Factor of linear light (cd/m²) in a picture for an exposure value at ISO 100: a white that just saturates the sensor becomes
 * 1. The saturating luminance is 78 / (S q) N² / t, with the q of common lenses, 0.65: 1.2 × 2^EV.
 * @see ISO 12232:2006, saturation based speed; Lagarde and de Rousiers 2014, Moving Frostbite to PBR, 5.1
 */
export const exposureOfEV = (ev: number): number => 1 / (1.2 * 2 ** ev);

/**
 * Exposure value at ISO 100 of a camera's settings.
 * @param aperture - f-number
 * @param time - exposure time (s)
 * @param iso - sensitivity of the sensor (ISO)
 */
export const evOfCamera = (aperture: number, time: number, iso: number): number =>
  Math.log2(((aperture * aperture) / time) * (100 / iso));

/** Exposure value at ISO 100 of a mean luminance (cd/m²), by a reflected-light meter. @see ISO 2720, K = 12.5 */
export const evOfLuminance = (luminance: number): number => Math.log2(luminance * 8);

/** Exposure value at ISO 100 of an illuminance (lx), by an incident-light meter. @see ISO 2720, C = 250 */
export const evOfIlluminance = (illuminance: number): number => Math.log2(illuminance / 2.5);
