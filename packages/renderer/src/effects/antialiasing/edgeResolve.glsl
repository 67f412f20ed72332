// The mean of the samples; where none of them is what the picture shows, but something not drawn anew, the picture.
// Chajdas, McGuire and Luebke 2011, Subpixel Reconstruction Antialiasing
uniform highp sampler2D farol_picture;
uniform highp sampler2D farol_samples; // alpha: coded as in edgeColor.glsl
uniform bool farol_whole; // all surfaces were drawn anew
layout(location = 0) out highp vec4 farol_color;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy);
farol_color = texelFetch(farol_samples, pixel, 0);
float shown = 2.0 * floor(0.5 * farol_color.a + 1e-3);
farol_color.a -= shown;
if (shown < 1.0 && !farol_whole) farol_color = texelFetch(farol_picture, pixel, 0);
