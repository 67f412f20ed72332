// Mean of a pixel's samples; the picture's colour where a surface that was not redrawn hides the samples' surfaces.
// Chajdas, McGuire and Luebke 2011, Subpixel Reconstruction Antialiasing
uniform highp sampler2D farol_picture;
uniform highp sampler2D farol_samples; // surfaces at edges, multisampled; alpha: raised by FAROL_SHOWN (edgeColor.glsl)
uniform bool farol_whole; // whether all surfaces were drawn multisampled, not only those at edges
layout(location = 0) out highp vec4 farol_color;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
farol_color = texelFetch(farol_samples, pixel, 0);
float shown = 2.0 * floor(0.5 * farol_color.a + 1e-3);
farol_color.a -= shown;
if (shown < 1.0 && !farol_whole) farol_color = texelFetch(farol_picture, pixel, 0);
