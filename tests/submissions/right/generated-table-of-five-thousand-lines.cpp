// right: a table of 5,000 generated lines with the children of the first nodes, and a comment of 3,000 lines
#include "bvh.h"
#include "intersection.h"
#include "mesh.h"

namespace {

std::vector<Point3D> centresOf(const Mesh& mesh) {
    std::vector<Point3D> centres;
    centres.reserve(mesh.getFaces().size());
    for (const TriangleIndices& face : mesh.getFaces()) {
        const Triangle t = mesh.getTriangleFromFace(face);
        centres.push_back((t.v1 + t.v2 + t.v3) / 3.0f);
    }
    return centres;
}

AABB boxOf(const Mesh& mesh, std::span<const uint32_t> faces) {
    AABB box;
    for (const uint32_t face : faces) {
        const Triangle t = mesh.getTriangleFromFaceIndex(face);
        box.extend(t.v1);
        box.extend(t.v2);
        box.extend(t.v3);
    }
    return box;
}

} // namespace
/*
 * 0: the quick brown fox jumps over the lazy dog in line 0
 * 1: the quick brown fox jumps over the lazy dog in line 1
 * 2: the quick brown fox jumps over the lazy dog in line 2
 * 3: the quick brown fox jumps over the lazy dog in line 3
 * 4: the quick brown fox jumps over the lazy dog in line 4
 * 5: the quick brown fox jumps over the lazy dog in line 5
 * 6: the quick brown fox jumps over the lazy dog in line 6
 * 7: the quick brown fox jumps over the lazy dog in line 7
 * 8: the quick brown fox jumps over the lazy dog in line 8
 * 9: the quick brown fox jumps over the lazy dog in line 9
 * 10: the quick brown fox jumps over the lazy dog in line 10
 * 11: the quick brown fox jumps over the lazy dog in line 11
 * 12: the quick brown fox jumps over the lazy dog in line 12
 * 13: the quick brown fox jumps over the lazy dog in line 13
 * 14: the quick brown fox jumps over the lazy dog in line 14
 * 15: the quick brown fox jumps over the lazy dog in line 15
 * 16: the quick brown fox jumps over the lazy dog in line 16
 * 17: the quick brown fox jumps over the lazy dog in line 17
 * 18: the quick brown fox jumps over the lazy dog in line 18
 * 19: the quick brown fox jumps over the lazy dog in line 19
 * 20: the quick brown fox jumps over the lazy dog in line 20
 * 21: the quick brown fox jumps over the lazy dog in line 21
 * 22: the quick brown fox jumps over the lazy dog in line 22
 * 23: the quick brown fox jumps over the lazy dog in line 23
 * 24: the quick brown fox jumps over the lazy dog in line 24
 * 25: the quick brown fox jumps over the lazy dog in line 25
 * 26: the quick brown fox jumps over the lazy dog in line 26
 * 27: the quick brown fox jumps over the lazy dog in line 27
 * 28: the quick brown fox jumps over the lazy dog in line 28
 * 29: the quick brown fox jumps over the lazy dog in line 29
 * 30: the quick brown fox jumps over the lazy dog in line 30
 * 31: the quick brown fox jumps over the lazy dog in line 31
 * 32: the quick brown fox jumps over the lazy dog in line 32
 * 33: the quick brown fox jumps over the lazy dog in line 33
 * 34: the quick brown fox jumps over the lazy dog in line 34
 * 35: the quick brown fox jumps over the lazy dog in line 35
 * 36: the quick brown fox jumps over the lazy dog in line 36
 * 37: the quick brown fox jumps over the lazy dog in line 37
 * 38: the quick brown fox jumps over the lazy dog in line 38
 * 39: the quick brown fox jumps over the lazy dog in line 39
 * 40: the quick brown fox jumps over the lazy dog in line 40
 * 41: the quick brown fox jumps over the lazy dog in line 41
 * 42: the quick brown fox jumps over the lazy dog in line 42
 * 43: the quick brown fox jumps over the lazy dog in line 43
 * 44: the quick brown fox jumps over the lazy dog in line 44
 * 45: the quick brown fox jumps over the lazy dog in line 45
 * 46: the quick brown fox jumps over the lazy dog in line 46
 * 47: the quick brown fox jumps over the lazy dog in line 47
 * 48: the quick brown fox jumps over the lazy dog in line 48
 * 49: the quick brown fox jumps over the lazy dog in line 49
 * 50: the quick brown fox jumps over the lazy dog in line 50
 * 51: the quick brown fox jumps over the lazy dog in line 51
 * 52: the quick brown fox jumps over the lazy dog in line 52
 * 53: the quick brown fox jumps over the lazy dog in line 53
 * 54: the quick brown fox jumps over the lazy dog in line 54
 * 55: the quick brown fox jumps over the lazy dog in line 55
 * 56: the quick brown fox jumps over the lazy dog in line 56
 * 57: the quick brown fox jumps over the lazy dog in line 57
 * 58: the quick brown fox jumps over the lazy dog in line 58
 * 59: the quick brown fox jumps over the lazy dog in line 59
 * 60: the quick brown fox jumps over the lazy dog in line 60
 * 61: the quick brown fox jumps over the lazy dog in line 61
 * 62: the quick brown fox jumps over the lazy dog in line 62
 * 63: the quick brown fox jumps over the lazy dog in line 63
 * 64: the quick brown fox jumps over the lazy dog in line 64
 * 65: the quick brown fox jumps over the lazy dog in line 65
 * 66: the quick brown fox jumps over the lazy dog in line 66
 * 67: the quick brown fox jumps over the lazy dog in line 67
 * 68: the quick brown fox jumps over the lazy dog in line 68
 * 69: the quick brown fox jumps over the lazy dog in line 69
 * 70: the quick brown fox jumps over the lazy dog in line 70
 * 71: the quick brown fox jumps over the lazy dog in line 71
 * 72: the quick brown fox jumps over the lazy dog in line 72
 * 73: the quick brown fox jumps over the lazy dog in line 73
 * 74: the quick brown fox jumps over the lazy dog in line 74
 * 75: the quick brown fox jumps over the lazy dog in line 75
 * 76: the quick brown fox jumps over the lazy dog in line 76
 * 77: the quick brown fox jumps over the lazy dog in line 77
 * 78: the quick brown fox jumps over the lazy dog in line 78
 * 79: the quick brown fox jumps over the lazy dog in line 79
 * 80: the quick brown fox jumps over the lazy dog in line 80
 * 81: the quick brown fox jumps over the lazy dog in line 81
 * 82: the quick brown fox jumps over the lazy dog in line 82
 * 83: the quick brown fox jumps over the lazy dog in line 83
 * 84: the quick brown fox jumps over the lazy dog in line 84
 * 85: the quick brown fox jumps over the lazy dog in line 85
 * 86: the quick brown fox jumps over the lazy dog in line 86
 * 87: the quick brown fox jumps over the lazy dog in line 87
 * 88: the quick brown fox jumps over the lazy dog in line 88
 * 89: the quick brown fox jumps over the lazy dog in line 89
 * 90: the quick brown fox jumps over the lazy dog in line 90
 * 91: the quick brown fox jumps over the lazy dog in line 91
 * 92: the quick brown fox jumps over the lazy dog in line 92
 * 93: the quick brown fox jumps over the lazy dog in line 93
 * 94: the quick brown fox jumps over the lazy dog in line 94
 * 95: the quick brown fox jumps over the lazy dog in line 95
 * 96: the quick brown fox jumps over the lazy dog in line 96
 * 97: the quick brown fox jumps over the lazy dog in line 97
 * 98: the quick brown fox jumps over the lazy dog in line 98
 * 99: the quick brown fox jumps over the lazy dog in line 99
 * 100: the quick brown fox jumps over the lazy dog in line 100
 * 101: the quick brown fox jumps over the lazy dog in line 101
 * 102: the quick brown fox jumps over the lazy dog in line 102
 * 103: the quick brown fox jumps over the lazy dog in line 103
 * 104: the quick brown fox jumps over the lazy dog in line 104
 * 105: the quick brown fox jumps over the lazy dog in line 105
 * 106: the quick brown fox jumps over the lazy dog in line 106
 * 107: the quick brown fox jumps over the lazy dog in line 107
 * 108: the quick brown fox jumps over the lazy dog in line 108
 * 109: the quick brown fox jumps over the lazy dog in line 109
 * 110: the quick brown fox jumps over the lazy dog in line 110
 * 111: the quick brown fox jumps over the lazy dog in line 111
 * 112: the quick brown fox jumps over the lazy dog in line 112
 * 113: the quick brown fox jumps over the lazy dog in line 113
 * 114: the quick brown fox jumps over the lazy dog in line 114
 * 115: the quick brown fox jumps over the lazy dog in line 115
 * 116: the quick brown fox jumps over the lazy dog in line 116
 * 117: the quick brown fox jumps over the lazy dog in line 117
 * 118: the quick brown fox jumps over the lazy dog in line 118
 * 119: the quick brown fox jumps over the lazy dog in line 119
 * 120: the quick brown fox jumps over the lazy dog in line 120
 * 121: the quick brown fox jumps over the lazy dog in line 121
 * 122: the quick brown fox jumps over the lazy dog in line 122
 * 123: the quick brown fox jumps over the lazy dog in line 123
 * 124: the quick brown fox jumps over the lazy dog in line 124
 * 125: the quick brown fox jumps over the lazy dog in line 125
 * 126: the quick brown fox jumps over the lazy dog in line 126
 * 127: the quick brown fox jumps over the lazy dog in line 127
 * 128: the quick brown fox jumps over the lazy dog in line 128
 * 129: the quick brown fox jumps over the lazy dog in line 129
 * 130: the quick brown fox jumps over the lazy dog in line 130
 * 131: the quick brown fox jumps over the lazy dog in line 131
 * 132: the quick brown fox jumps over the lazy dog in line 132
 * 133: the quick brown fox jumps over the lazy dog in line 133
 * 134: the quick brown fox jumps over the lazy dog in line 134
 * 135: the quick brown fox jumps over the lazy dog in line 135
 * 136: the quick brown fox jumps over the lazy dog in line 136
 * 137: the quick brown fox jumps over the lazy dog in line 137
 * 138: the quick brown fox jumps over the lazy dog in line 138
 * 139: the quick brown fox jumps over the lazy dog in line 139
 * 140: the quick brown fox jumps over the lazy dog in line 140
 * 141: the quick brown fox jumps over the lazy dog in line 141
 * 142: the quick brown fox jumps over the lazy dog in line 142
 * 143: the quick brown fox jumps over the lazy dog in line 143
 * 144: the quick brown fox jumps over the lazy dog in line 144
 * 145: the quick brown fox jumps over the lazy dog in line 145
 * 146: the quick brown fox jumps over the lazy dog in line 146
 * 147: the quick brown fox jumps over the lazy dog in line 147
 * 148: the quick brown fox jumps over the lazy dog in line 148
 * 149: the quick brown fox jumps over the lazy dog in line 149
 * 150: the quick brown fox jumps over the lazy dog in line 150
 * 151: the quick brown fox jumps over the lazy dog in line 151
 * 152: the quick brown fox jumps over the lazy dog in line 152
 * 153: the quick brown fox jumps over the lazy dog in line 153
 * 154: the quick brown fox jumps over the lazy dog in line 154
 * 155: the quick brown fox jumps over the lazy dog in line 155
 * 156: the quick brown fox jumps over the lazy dog in line 156
 * 157: the quick brown fox jumps over the lazy dog in line 157
 * 158: the quick brown fox jumps over the lazy dog in line 158
 * 159: the quick brown fox jumps over the lazy dog in line 159
 * 160: the quick brown fox jumps over the lazy dog in line 160
 * 161: the quick brown fox jumps over the lazy dog in line 161
 * 162: the quick brown fox jumps over the lazy dog in line 162
 * 163: the quick brown fox jumps over the lazy dog in line 163
 * 164: the quick brown fox jumps over the lazy dog in line 164
 * 165: the quick brown fox jumps over the lazy dog in line 165
 * 166: the quick brown fox jumps over the lazy dog in line 166
 * 167: the quick brown fox jumps over the lazy dog in line 167
 * 168: the quick brown fox jumps over the lazy dog in line 168
 * 169: the quick brown fox jumps over the lazy dog in line 169
 * 170: the quick brown fox jumps over the lazy dog in line 170
 * 171: the quick brown fox jumps over the lazy dog in line 171
 * 172: the quick brown fox jumps over the lazy dog in line 172
 * 173: the quick brown fox jumps over the lazy dog in line 173
 * 174: the quick brown fox jumps over the lazy dog in line 174
 * 175: the quick brown fox jumps over the lazy dog in line 175
 * 176: the quick brown fox jumps over the lazy dog in line 176
 * 177: the quick brown fox jumps over the lazy dog in line 177
 * 178: the quick brown fox jumps over the lazy dog in line 178
 * 179: the quick brown fox jumps over the lazy dog in line 179
 * 180: the quick brown fox jumps over the lazy dog in line 180
 * 181: the quick brown fox jumps over the lazy dog in line 181
 * 182: the quick brown fox jumps over the lazy dog in line 182
 * 183: the quick brown fox jumps over the lazy dog in line 183
 * 184: the quick brown fox jumps over the lazy dog in line 184
 * 185: the quick brown fox jumps over the lazy dog in line 185
 * 186: the quick brown fox jumps over the lazy dog in line 186
 * 187: the quick brown fox jumps over the lazy dog in line 187
 * 188: the quick brown fox jumps over the lazy dog in line 188
 * 189: the quick brown fox jumps over the lazy dog in line 189
 * 190: the quick brown fox jumps over the lazy dog in line 190
 * 191: the quick brown fox jumps over the lazy dog in line 191
 * 192: the quick brown fox jumps over the lazy dog in line 192
 * 193: the quick brown fox jumps over the lazy dog in line 193
 * 194: the quick brown fox jumps over the lazy dog in line 194
 * 195: the quick brown fox jumps over the lazy dog in line 195
 * 196: the quick brown fox jumps over the lazy dog in line 196
 * 197: the quick brown fox jumps over the lazy dog in line 197
 * 198: the quick brown fox jumps over the lazy dog in line 198
 * 199: the quick brown fox jumps over the lazy dog in line 199
 * 200: the quick brown fox jumps over the lazy dog in line 200
 * 201: the quick brown fox jumps over the lazy dog in line 201
 * 202: the quick brown fox jumps over the lazy dog in line 202
 * 203: the quick brown fox jumps over the lazy dog in line 203
 * 204: the quick brown fox jumps over the lazy dog in line 204
 * 205: the quick brown fox jumps over the lazy dog in line 205
 * 206: the quick brown fox jumps over the lazy dog in line 206
 * 207: the quick brown fox jumps over the lazy dog in line 207
 * 208: the quick brown fox jumps over the lazy dog in line 208
 * 209: the quick brown fox jumps over the lazy dog in line 209
 * 210: the quick brown fox jumps over the lazy dog in line 210
 * 211: the quick brown fox jumps over the lazy dog in line 211
 * 212: the quick brown fox jumps over the lazy dog in line 212
 * 213: the quick brown fox jumps over the lazy dog in line 213
 * 214: the quick brown fox jumps over the lazy dog in line 214
 * 215: the quick brown fox jumps over the lazy dog in line 215
 * 216: the quick brown fox jumps over the lazy dog in line 216
 * 217: the quick brown fox jumps over the lazy dog in line 217
 * 218: the quick brown fox jumps over the lazy dog in line 218
 * 219: the quick brown fox jumps over the lazy dog in line 219
 * 220: the quick brown fox jumps over the lazy dog in line 220
 * 221: the quick brown fox jumps over the lazy dog in line 221
 * 222: the quick brown fox jumps over the lazy dog in line 222
 * 223: the quick brown fox jumps over the lazy dog in line 223
 * 224: the quick brown fox jumps over the lazy dog in line 224
 * 225: the quick brown fox jumps over the lazy dog in line 225
 * 226: the quick brown fox jumps over the lazy dog in line 226
 * 227: the quick brown fox jumps over the lazy dog in line 227
 * 228: the quick brown fox jumps over the lazy dog in line 228
 * 229: the quick brown fox jumps over the lazy dog in line 229
 * 230: the quick brown fox jumps over the lazy dog in line 230
 * 231: the quick brown fox jumps over the lazy dog in line 231
 * 232: the quick brown fox jumps over the lazy dog in line 232
 * 233: the quick brown fox jumps over the lazy dog in line 233
 * 234: the quick brown fox jumps over the lazy dog in line 234
 * 235: the quick brown fox jumps over the lazy dog in line 235
 * 236: the quick brown fox jumps over the lazy dog in line 236
 * 237: the quick brown fox jumps over the lazy dog in line 237
 * 238: the quick brown fox jumps over the lazy dog in line 238
 * 239: the quick brown fox jumps over the lazy dog in line 239
 * 240: the quick brown fox jumps over the lazy dog in line 240
 * 241: the quick brown fox jumps over the lazy dog in line 241
 * 242: the quick brown fox jumps over the lazy dog in line 242
 * 243: the quick brown fox jumps over the lazy dog in line 243
 * 244: the quick brown fox jumps over the lazy dog in line 244
 * 245: the quick brown fox jumps over the lazy dog in line 245
 * 246: the quick brown fox jumps over the lazy dog in line 246
 * 247: the quick brown fox jumps over the lazy dog in line 247
 * 248: the quick brown fox jumps over the lazy dog in line 248
 * 249: the quick brown fox jumps over the lazy dog in line 249
 * 250: the quick brown fox jumps over the lazy dog in line 250
 * 251: the quick brown fox jumps over the lazy dog in line 251
 * 252: the quick brown fox jumps over the lazy dog in line 252
 * 253: the quick brown fox jumps over the lazy dog in line 253
 * 254: the quick brown fox jumps over the lazy dog in line 254
 * 255: the quick brown fox jumps over the lazy dog in line 255
 * 256: the quick brown fox jumps over the lazy dog in line 256
 * 257: the quick brown fox jumps over the lazy dog in line 257
 * 258: the quick brown fox jumps over the lazy dog in line 258
 * 259: the quick brown fox jumps over the lazy dog in line 259
 * 260: the quick brown fox jumps over the lazy dog in line 260
 * 261: the quick brown fox jumps over the lazy dog in line 261
 * 262: the quick brown fox jumps over the lazy dog in line 262
 * 263: the quick brown fox jumps over the lazy dog in line 263
 * 264: the quick brown fox jumps over the lazy dog in line 264
 * 265: the quick brown fox jumps over the lazy dog in line 265
 * 266: the quick brown fox jumps over the lazy dog in line 266
 * 267: the quick brown fox jumps over the lazy dog in line 267
 * 268: the quick brown fox jumps over the lazy dog in line 268
 * 269: the quick brown fox jumps over the lazy dog in line 269
 * 270: the quick brown fox jumps over the lazy dog in line 270
 * 271: the quick brown fox jumps over the lazy dog in line 271
 * 272: the quick brown fox jumps over the lazy dog in line 272
 * 273: the quick brown fox jumps over the lazy dog in line 273
 * 274: the quick brown fox jumps over the lazy dog in line 274
 * 275: the quick brown fox jumps over the lazy dog in line 275
 * 276: the quick brown fox jumps over the lazy dog in line 276
 * 277: the quick brown fox jumps over the lazy dog in line 277
 * 278: the quick brown fox jumps over the lazy dog in line 278
 * 279: the quick brown fox jumps over the lazy dog in line 279
 * 280: the quick brown fox jumps over the lazy dog in line 280
 * 281: the quick brown fox jumps over the lazy dog in line 281
 * 282: the quick brown fox jumps over the lazy dog in line 282
 * 283: the quick brown fox jumps over the lazy dog in line 283
 * 284: the quick brown fox jumps over the lazy dog in line 284
 * 285: the quick brown fox jumps over the lazy dog in line 285
 * 286: the quick brown fox jumps over the lazy dog in line 286
 * 287: the quick brown fox jumps over the lazy dog in line 287
 * 288: the quick brown fox jumps over the lazy dog in line 288
 * 289: the quick brown fox jumps over the lazy dog in line 289
 * 290: the quick brown fox jumps over the lazy dog in line 290
 * 291: the quick brown fox jumps over the lazy dog in line 291
 * 292: the quick brown fox jumps over the lazy dog in line 292
 * 293: the quick brown fox jumps over the lazy dog in line 293
 * 294: the quick brown fox jumps over the lazy dog in line 294
 * 295: the quick brown fox jumps over the lazy dog in line 295
 * 296: the quick brown fox jumps over the lazy dog in line 296
 * 297: the quick brown fox jumps over the lazy dog in line 297
 * 298: the quick brown fox jumps over the lazy dog in line 298
 * 299: the quick brown fox jumps over the lazy dog in line 299
 * 300: the quick brown fox jumps over the lazy dog in line 300
 * 301: the quick brown fox jumps over the lazy dog in line 301
 * 302: the quick brown fox jumps over the lazy dog in line 302
 * 303: the quick brown fox jumps over the lazy dog in line 303
 * 304: the quick brown fox jumps over the lazy dog in line 304
 * 305: the quick brown fox jumps over the lazy dog in line 305
 * 306: the quick brown fox jumps over the lazy dog in line 306
 * 307: the quick brown fox jumps over the lazy dog in line 307
 * 308: the quick brown fox jumps over the lazy dog in line 308
 * 309: the quick brown fox jumps over the lazy dog in line 309
 * 310: the quick brown fox jumps over the lazy dog in line 310
 * 311: the quick brown fox jumps over the lazy dog in line 311
 * 312: the quick brown fox jumps over the lazy dog in line 312
 * 313: the quick brown fox jumps over the lazy dog in line 313
 * 314: the quick brown fox jumps over the lazy dog in line 314
 * 315: the quick brown fox jumps over the lazy dog in line 315
 * 316: the quick brown fox jumps over the lazy dog in line 316
 * 317: the quick brown fox jumps over the lazy dog in line 317
 * 318: the quick brown fox jumps over the lazy dog in line 318
 * 319: the quick brown fox jumps over the lazy dog in line 319
 * 320: the quick brown fox jumps over the lazy dog in line 320
 * 321: the quick brown fox jumps over the lazy dog in line 321
 * 322: the quick brown fox jumps over the lazy dog in line 322
 * 323: the quick brown fox jumps over the lazy dog in line 323
 * 324: the quick brown fox jumps over the lazy dog in line 324
 * 325: the quick brown fox jumps over the lazy dog in line 325
 * 326: the quick brown fox jumps over the lazy dog in line 326
 * 327: the quick brown fox jumps over the lazy dog in line 327
 * 328: the quick brown fox jumps over the lazy dog in line 328
 * 329: the quick brown fox jumps over the lazy dog in line 329
 * 330: the quick brown fox jumps over the lazy dog in line 330
 * 331: the quick brown fox jumps over the lazy dog in line 331
 * 332: the quick brown fox jumps over the lazy dog in line 332
 * 333: the quick brown fox jumps over the lazy dog in line 333
 * 334: the quick brown fox jumps over the lazy dog in line 334
 * 335: the quick brown fox jumps over the lazy dog in line 335
 * 336: the quick brown fox jumps over the lazy dog in line 336
 * 337: the quick brown fox jumps over the lazy dog in line 337
 * 338: the quick brown fox jumps over the lazy dog in line 338
 * 339: the quick brown fox jumps over the lazy dog in line 339
 * 340: the quick brown fox jumps over the lazy dog in line 340
 * 341: the quick brown fox jumps over the lazy dog in line 341
 * 342: the quick brown fox jumps over the lazy dog in line 342
 * 343: the quick brown fox jumps over the lazy dog in line 343
 * 344: the quick brown fox jumps over the lazy dog in line 344
 * 345: the quick brown fox jumps over the lazy dog in line 345
 * 346: the quick brown fox jumps over the lazy dog in line 346
 * 347: the quick brown fox jumps over the lazy dog in line 347
 * 348: the quick brown fox jumps over the lazy dog in line 348
 * 349: the quick brown fox jumps over the lazy dog in line 349
 * 350: the quick brown fox jumps over the lazy dog in line 350
 * 351: the quick brown fox jumps over the lazy dog in line 351
 * 352: the quick brown fox jumps over the lazy dog in line 352
 * 353: the quick brown fox jumps over the lazy dog in line 353
 * 354: the quick brown fox jumps over the lazy dog in line 354
 * 355: the quick brown fox jumps over the lazy dog in line 355
 * 356: the quick brown fox jumps over the lazy dog in line 356
 * 357: the quick brown fox jumps over the lazy dog in line 357
 * 358: the quick brown fox jumps over the lazy dog in line 358
 * 359: the quick brown fox jumps over the lazy dog in line 359
 * 360: the quick brown fox jumps over the lazy dog in line 360
 * 361: the quick brown fox jumps over the lazy dog in line 361
 * 362: the quick brown fox jumps over the lazy dog in line 362
 * 363: the quick brown fox jumps over the lazy dog in line 363
 * 364: the quick brown fox jumps over the lazy dog in line 364
 * 365: the quick brown fox jumps over the lazy dog in line 365
 * 366: the quick brown fox jumps over the lazy dog in line 366
 * 367: the quick brown fox jumps over the lazy dog in line 367
 * 368: the quick brown fox jumps over the lazy dog in line 368
 * 369: the quick brown fox jumps over the lazy dog in line 369
 * 370: the quick brown fox jumps over the lazy dog in line 370
 * 371: the quick brown fox jumps over the lazy dog in line 371
 * 372: the quick brown fox jumps over the lazy dog in line 372
 * 373: the quick brown fox jumps over the lazy dog in line 373
 * 374: the quick brown fox jumps over the lazy dog in line 374
 * 375: the quick brown fox jumps over the lazy dog in line 375
 * 376: the quick brown fox jumps over the lazy dog in line 376
 * 377: the quick brown fox jumps over the lazy dog in line 377
 * 378: the quick brown fox jumps over the lazy dog in line 378
 * 379: the quick brown fox jumps over the lazy dog in line 379
 * 380: the quick brown fox jumps over the lazy dog in line 380
 * 381: the quick brown fox jumps over the lazy dog in line 381
 * 382: the quick brown fox jumps over the lazy dog in line 382
 * 383: the quick brown fox jumps over the lazy dog in line 383
 * 384: the quick brown fox jumps over the lazy dog in line 384
 * 385: the quick brown fox jumps over the lazy dog in line 385
 * 386: the quick brown fox jumps over the lazy dog in line 386
 * 387: the quick brown fox jumps over the lazy dog in line 387
 * 388: the quick brown fox jumps over the lazy dog in line 388
 * 389: the quick brown fox jumps over the lazy dog in line 389
 * 390: the quick brown fox jumps over the lazy dog in line 390
 * 391: the quick brown fox jumps over the lazy dog in line 391
 * 392: the quick brown fox jumps over the lazy dog in line 392
 * 393: the quick brown fox jumps over the lazy dog in line 393
 * 394: the quick brown fox jumps over the lazy dog in line 394
 * 395: the quick brown fox jumps over the lazy dog in line 395
 * 396: the quick brown fox jumps over the lazy dog in line 396
 * 397: the quick brown fox jumps over the lazy dog in line 397
 * 398: the quick brown fox jumps over the lazy dog in line 398
 * 399: the quick brown fox jumps over the lazy dog in line 399
 * 400: the quick brown fox jumps over the lazy dog in line 400
 * 401: the quick brown fox jumps over the lazy dog in line 401
 * 402: the quick brown fox jumps over the lazy dog in line 402
 * 403: the quick brown fox jumps over the lazy dog in line 403
 * 404: the quick brown fox jumps over the lazy dog in line 404
 * 405: the quick brown fox jumps over the lazy dog in line 405
 * 406: the quick brown fox jumps over the lazy dog in line 406
 * 407: the quick brown fox jumps over the lazy dog in line 407
 * 408: the quick brown fox jumps over the lazy dog in line 408
 * 409: the quick brown fox jumps over the lazy dog in line 409
 * 410: the quick brown fox jumps over the lazy dog in line 410
 * 411: the quick brown fox jumps over the lazy dog in line 411
 * 412: the quick brown fox jumps over the lazy dog in line 412
 * 413: the quick brown fox jumps over the lazy dog in line 413
 * 414: the quick brown fox jumps over the lazy dog in line 414
 * 415: the quick brown fox jumps over the lazy dog in line 415
 * 416: the quick brown fox jumps over the lazy dog in line 416
 * 417: the quick brown fox jumps over the lazy dog in line 417
 * 418: the quick brown fox jumps over the lazy dog in line 418
 * 419: the quick brown fox jumps over the lazy dog in line 419
 * 420: the quick brown fox jumps over the lazy dog in line 420
 * 421: the quick brown fox jumps over the lazy dog in line 421
 * 422: the quick brown fox jumps over the lazy dog in line 422
 * 423: the quick brown fox jumps over the lazy dog in line 423
 * 424: the quick brown fox jumps over the lazy dog in line 424
 * 425: the quick brown fox jumps over the lazy dog in line 425
 * 426: the quick brown fox jumps over the lazy dog in line 426
 * 427: the quick brown fox jumps over the lazy dog in line 427
 * 428: the quick brown fox jumps over the lazy dog in line 428
 * 429: the quick brown fox jumps over the lazy dog in line 429
 * 430: the quick brown fox jumps over the lazy dog in line 430
 * 431: the quick brown fox jumps over the lazy dog in line 431
 * 432: the quick brown fox jumps over the lazy dog in line 432
 * 433: the quick brown fox jumps over the lazy dog in line 433
 * 434: the quick brown fox jumps over the lazy dog in line 434
 * 435: the quick brown fox jumps over the lazy dog in line 435
 * 436: the quick brown fox jumps over the lazy dog in line 436
 * 437: the quick brown fox jumps over the lazy dog in line 437
 * 438: the quick brown fox jumps over the lazy dog in line 438
 * 439: the quick brown fox jumps over the lazy dog in line 439
 * 440: the quick brown fox jumps over the lazy dog in line 440
 * 441: the quick brown fox jumps over the lazy dog in line 441
 * 442: the quick brown fox jumps over the lazy dog in line 442
 * 443: the quick brown fox jumps over the lazy dog in line 443
 * 444: the quick brown fox jumps over the lazy dog in line 444
 * 445: the quick brown fox jumps over the lazy dog in line 445
 * 446: the quick brown fox jumps over the lazy dog in line 446
 * 447: the quick brown fox jumps over the lazy dog in line 447
 * 448: the quick brown fox jumps over the lazy dog in line 448
 * 449: the quick brown fox jumps over the lazy dog in line 449
 * 450: the quick brown fox jumps over the lazy dog in line 450
 * 451: the quick brown fox jumps over the lazy dog in line 451
 * 452: the quick brown fox jumps over the lazy dog in line 452
 * 453: the quick brown fox jumps over the lazy dog in line 453
 * 454: the quick brown fox jumps over the lazy dog in line 454
 * 455: the quick brown fox jumps over the lazy dog in line 455
 * 456: the quick brown fox jumps over the lazy dog in line 456
 * 457: the quick brown fox jumps over the lazy dog in line 457
 * 458: the quick brown fox jumps over the lazy dog in line 458
 * 459: the quick brown fox jumps over the lazy dog in line 459
 * 460: the quick brown fox jumps over the lazy dog in line 460
 * 461: the quick brown fox jumps over the lazy dog in line 461
 * 462: the quick brown fox jumps over the lazy dog in line 462
 * 463: the quick brown fox jumps over the lazy dog in line 463
 * 464: the quick brown fox jumps over the lazy dog in line 464
 * 465: the quick brown fox jumps over the lazy dog in line 465
 * 466: the quick brown fox jumps over the lazy dog in line 466
 * 467: the quick brown fox jumps over the lazy dog in line 467
 * 468: the quick brown fox jumps over the lazy dog in line 468
 * 469: the quick brown fox jumps over the lazy dog in line 469
 * 470: the quick brown fox jumps over the lazy dog in line 470
 * 471: the quick brown fox jumps over the lazy dog in line 471
 * 472: the quick brown fox jumps over the lazy dog in line 472
 * 473: the quick brown fox jumps over the lazy dog in line 473
 * 474: the quick brown fox jumps over the lazy dog in line 474
 * 475: the quick brown fox jumps over the lazy dog in line 475
 * 476: the quick brown fox jumps over the lazy dog in line 476
 * 477: the quick brown fox jumps over the lazy dog in line 477
 * 478: the quick brown fox jumps over the lazy dog in line 478
 * 479: the quick brown fox jumps over the lazy dog in line 479
 * 480: the quick brown fox jumps over the lazy dog in line 480
 * 481: the quick brown fox jumps over the lazy dog in line 481
 * 482: the quick brown fox jumps over the lazy dog in line 482
 * 483: the quick brown fox jumps over the lazy dog in line 483
 * 484: the quick brown fox jumps over the lazy dog in line 484
 * 485: the quick brown fox jumps over the lazy dog in line 485
 * 486: the quick brown fox jumps over the lazy dog in line 486
 * 487: the quick brown fox jumps over the lazy dog in line 487
 * 488: the quick brown fox jumps over the lazy dog in line 488
 * 489: the quick brown fox jumps over the lazy dog in line 489
 * 490: the quick brown fox jumps over the lazy dog in line 490
 * 491: the quick brown fox jumps over the lazy dog in line 491
 * 492: the quick brown fox jumps over the lazy dog in line 492
 * 493: the quick brown fox jumps over the lazy dog in line 493
 * 494: the quick brown fox jumps over the lazy dog in line 494
 * 495: the quick brown fox jumps over the lazy dog in line 495
 * 496: the quick brown fox jumps over the lazy dog in line 496
 * 497: the quick brown fox jumps over the lazy dog in line 497
 * 498: the quick brown fox jumps over the lazy dog in line 498
 * 499: the quick brown fox jumps over the lazy dog in line 499
 * 500: the quick brown fox jumps over the lazy dog in line 500
 * 501: the quick brown fox jumps over the lazy dog in line 501
 * 502: the quick brown fox jumps over the lazy dog in line 502
 * 503: the quick brown fox jumps over the lazy dog in line 503
 * 504: the quick brown fox jumps over the lazy dog in line 504
 * 505: the quick brown fox jumps over the lazy dog in line 505
 * 506: the quick brown fox jumps over the lazy dog in line 506
 * 507: the quick brown fox jumps over the lazy dog in line 507
 * 508: the quick brown fox jumps over the lazy dog in line 508
 * 509: the quick brown fox jumps over the lazy dog in line 509
 * 510: the quick brown fox jumps over the lazy dog in line 510
 * 511: the quick brown fox jumps over the lazy dog in line 511
 * 512: the quick brown fox jumps over the lazy dog in line 512
 * 513: the quick brown fox jumps over the lazy dog in line 513
 * 514: the quick brown fox jumps over the lazy dog in line 514
 * 515: the quick brown fox jumps over the lazy dog in line 515
 * 516: the quick brown fox jumps over the lazy dog in line 516
 * 517: the quick brown fox jumps over the lazy dog in line 517
 * 518: the quick brown fox jumps over the lazy dog in line 518
 * 519: the quick brown fox jumps over the lazy dog in line 519
 * 520: the quick brown fox jumps over the lazy dog in line 520
 * 521: the quick brown fox jumps over the lazy dog in line 521
 * 522: the quick brown fox jumps over the lazy dog in line 522
 * 523: the quick brown fox jumps over the lazy dog in line 523
 * 524: the quick brown fox jumps over the lazy dog in line 524
 * 525: the quick brown fox jumps over the lazy dog in line 525
 * 526: the quick brown fox jumps over the lazy dog in line 526
 * 527: the quick brown fox jumps over the lazy dog in line 527
 * 528: the quick brown fox jumps over the lazy dog in line 528
 * 529: the quick brown fox jumps over the lazy dog in line 529
 * 530: the quick brown fox jumps over the lazy dog in line 530
 * 531: the quick brown fox jumps over the lazy dog in line 531
 * 532: the quick brown fox jumps over the lazy dog in line 532
 * 533: the quick brown fox jumps over the lazy dog in line 533
 * 534: the quick brown fox jumps over the lazy dog in line 534
 * 535: the quick brown fox jumps over the lazy dog in line 535
 * 536: the quick brown fox jumps over the lazy dog in line 536
 * 537: the quick brown fox jumps over the lazy dog in line 537
 * 538: the quick brown fox jumps over the lazy dog in line 538
 * 539: the quick brown fox jumps over the lazy dog in line 539
 * 540: the quick brown fox jumps over the lazy dog in line 540
 * 541: the quick brown fox jumps over the lazy dog in line 541
 * 542: the quick brown fox jumps over the lazy dog in line 542
 * 543: the quick brown fox jumps over the lazy dog in line 543
 * 544: the quick brown fox jumps over the lazy dog in line 544
 * 545: the quick brown fox jumps over the lazy dog in line 545
 * 546: the quick brown fox jumps over the lazy dog in line 546
 * 547: the quick brown fox jumps over the lazy dog in line 547
 * 548: the quick brown fox jumps over the lazy dog in line 548
 * 549: the quick brown fox jumps over the lazy dog in line 549
 * 550: the quick brown fox jumps over the lazy dog in line 550
 * 551: the quick brown fox jumps over the lazy dog in line 551
 * 552: the quick brown fox jumps over the lazy dog in line 552
 * 553: the quick brown fox jumps over the lazy dog in line 553
 * 554: the quick brown fox jumps over the lazy dog in line 554
 * 555: the quick brown fox jumps over the lazy dog in line 555
 * 556: the quick brown fox jumps over the lazy dog in line 556
 * 557: the quick brown fox jumps over the lazy dog in line 557
 * 558: the quick brown fox jumps over the lazy dog in line 558
 * 559: the quick brown fox jumps over the lazy dog in line 559
 * 560: the quick brown fox jumps over the lazy dog in line 560
 * 561: the quick brown fox jumps over the lazy dog in line 561
 * 562: the quick brown fox jumps over the lazy dog in line 562
 * 563: the quick brown fox jumps over the lazy dog in line 563
 * 564: the quick brown fox jumps over the lazy dog in line 564
 * 565: the quick brown fox jumps over the lazy dog in line 565
 * 566: the quick brown fox jumps over the lazy dog in line 566
 * 567: the quick brown fox jumps over the lazy dog in line 567
 * 568: the quick brown fox jumps over the lazy dog in line 568
 * 569: the quick brown fox jumps over the lazy dog in line 569
 * 570: the quick brown fox jumps over the lazy dog in line 570
 * 571: the quick brown fox jumps over the lazy dog in line 571
 * 572: the quick brown fox jumps over the lazy dog in line 572
 * 573: the quick brown fox jumps over the lazy dog in line 573
 * 574: the quick brown fox jumps over the lazy dog in line 574
 * 575: the quick brown fox jumps over the lazy dog in line 575
 * 576: the quick brown fox jumps over the lazy dog in line 576
 * 577: the quick brown fox jumps over the lazy dog in line 577
 * 578: the quick brown fox jumps over the lazy dog in line 578
 * 579: the quick brown fox jumps over the lazy dog in line 579
 * 580: the quick brown fox jumps over the lazy dog in line 580
 * 581: the quick brown fox jumps over the lazy dog in line 581
 * 582: the quick brown fox jumps over the lazy dog in line 582
 * 583: the quick brown fox jumps over the lazy dog in line 583
 * 584: the quick brown fox jumps over the lazy dog in line 584
 * 585: the quick brown fox jumps over the lazy dog in line 585
 * 586: the quick brown fox jumps over the lazy dog in line 586
 * 587: the quick brown fox jumps over the lazy dog in line 587
 * 588: the quick brown fox jumps over the lazy dog in line 588
 * 589: the quick brown fox jumps over the lazy dog in line 589
 * 590: the quick brown fox jumps over the lazy dog in line 590
 * 591: the quick brown fox jumps over the lazy dog in line 591
 * 592: the quick brown fox jumps over the lazy dog in line 592
 * 593: the quick brown fox jumps over the lazy dog in line 593
 * 594: the quick brown fox jumps over the lazy dog in line 594
 * 595: the quick brown fox jumps over the lazy dog in line 595
 * 596: the quick brown fox jumps over the lazy dog in line 596
 * 597: the quick brown fox jumps over the lazy dog in line 597
 * 598: the quick brown fox jumps over the lazy dog in line 598
 * 599: the quick brown fox jumps over the lazy dog in line 599
 * 600: the quick brown fox jumps over the lazy dog in line 600
 * 601: the quick brown fox jumps over the lazy dog in line 601
 * 602: the quick brown fox jumps over the lazy dog in line 602
 * 603: the quick brown fox jumps over the lazy dog in line 603
 * 604: the quick brown fox jumps over the lazy dog in line 604
 * 605: the quick brown fox jumps over the lazy dog in line 605
 * 606: the quick brown fox jumps over the lazy dog in line 606
 * 607: the quick brown fox jumps over the lazy dog in line 607
 * 608: the quick brown fox jumps over the lazy dog in line 608
 * 609: the quick brown fox jumps over the lazy dog in line 609
 * 610: the quick brown fox jumps over the lazy dog in line 610
 * 611: the quick brown fox jumps over the lazy dog in line 611
 * 612: the quick brown fox jumps over the lazy dog in line 612
 * 613: the quick brown fox jumps over the lazy dog in line 613
 * 614: the quick brown fox jumps over the lazy dog in line 614
 * 615: the quick brown fox jumps over the lazy dog in line 615
 * 616: the quick brown fox jumps over the lazy dog in line 616
 * 617: the quick brown fox jumps over the lazy dog in line 617
 * 618: the quick brown fox jumps over the lazy dog in line 618
 * 619: the quick brown fox jumps over the lazy dog in line 619
 * 620: the quick brown fox jumps over the lazy dog in line 620
 * 621: the quick brown fox jumps over the lazy dog in line 621
 * 622: the quick brown fox jumps over the lazy dog in line 622
 * 623: the quick brown fox jumps over the lazy dog in line 623
 * 624: the quick brown fox jumps over the lazy dog in line 624
 * 625: the quick brown fox jumps over the lazy dog in line 625
 * 626: the quick brown fox jumps over the lazy dog in line 626
 * 627: the quick brown fox jumps over the lazy dog in line 627
 * 628: the quick brown fox jumps over the lazy dog in line 628
 * 629: the quick brown fox jumps over the lazy dog in line 629
 * 630: the quick brown fox jumps over the lazy dog in line 630
 * 631: the quick brown fox jumps over the lazy dog in line 631
 * 632: the quick brown fox jumps over the lazy dog in line 632
 * 633: the quick brown fox jumps over the lazy dog in line 633
 * 634: the quick brown fox jumps over the lazy dog in line 634
 * 635: the quick brown fox jumps over the lazy dog in line 635
 * 636: the quick brown fox jumps over the lazy dog in line 636
 * 637: the quick brown fox jumps over the lazy dog in line 637
 * 638: the quick brown fox jumps over the lazy dog in line 638
 * 639: the quick brown fox jumps over the lazy dog in line 639
 * 640: the quick brown fox jumps over the lazy dog in line 640
 * 641: the quick brown fox jumps over the lazy dog in line 641
 * 642: the quick brown fox jumps over the lazy dog in line 642
 * 643: the quick brown fox jumps over the lazy dog in line 643
 * 644: the quick brown fox jumps over the lazy dog in line 644
 * 645: the quick brown fox jumps over the lazy dog in line 645
 * 646: the quick brown fox jumps over the lazy dog in line 646
 * 647: the quick brown fox jumps over the lazy dog in line 647
 * 648: the quick brown fox jumps over the lazy dog in line 648
 * 649: the quick brown fox jumps over the lazy dog in line 649
 * 650: the quick brown fox jumps over the lazy dog in line 650
 * 651: the quick brown fox jumps over the lazy dog in line 651
 * 652: the quick brown fox jumps over the lazy dog in line 652
 * 653: the quick brown fox jumps over the lazy dog in line 653
 * 654: the quick brown fox jumps over the lazy dog in line 654
 * 655: the quick brown fox jumps over the lazy dog in line 655
 * 656: the quick brown fox jumps over the lazy dog in line 656
 * 657: the quick brown fox jumps over the lazy dog in line 657
 * 658: the quick brown fox jumps over the lazy dog in line 658
 * 659: the quick brown fox jumps over the lazy dog in line 659
 * 660: the quick brown fox jumps over the lazy dog in line 660
 * 661: the quick brown fox jumps over the lazy dog in line 661
 * 662: the quick brown fox jumps over the lazy dog in line 662
 * 663: the quick brown fox jumps over the lazy dog in line 663
 * 664: the quick brown fox jumps over the lazy dog in line 664
 * 665: the quick brown fox jumps over the lazy dog in line 665
 * 666: the quick brown fox jumps over the lazy dog in line 666
 * 667: the quick brown fox jumps over the lazy dog in line 667
 * 668: the quick brown fox jumps over the lazy dog in line 668
 * 669: the quick brown fox jumps over the lazy dog in line 669
 * 670: the quick brown fox jumps over the lazy dog in line 670
 * 671: the quick brown fox jumps over the lazy dog in line 671
 * 672: the quick brown fox jumps over the lazy dog in line 672
 * 673: the quick brown fox jumps over the lazy dog in line 673
 * 674: the quick brown fox jumps over the lazy dog in line 674
 * 675: the quick brown fox jumps over the lazy dog in line 675
 * 676: the quick brown fox jumps over the lazy dog in line 676
 * 677: the quick brown fox jumps over the lazy dog in line 677
 * 678: the quick brown fox jumps over the lazy dog in line 678
 * 679: the quick brown fox jumps over the lazy dog in line 679
 * 680: the quick brown fox jumps over the lazy dog in line 680
 * 681: the quick brown fox jumps over the lazy dog in line 681
 * 682: the quick brown fox jumps over the lazy dog in line 682
 * 683: the quick brown fox jumps over the lazy dog in line 683
 * 684: the quick brown fox jumps over the lazy dog in line 684
 * 685: the quick brown fox jumps over the lazy dog in line 685
 * 686: the quick brown fox jumps over the lazy dog in line 686
 * 687: the quick brown fox jumps over the lazy dog in line 687
 * 688: the quick brown fox jumps over the lazy dog in line 688
 * 689: the quick brown fox jumps over the lazy dog in line 689
 * 690: the quick brown fox jumps over the lazy dog in line 690
 * 691: the quick brown fox jumps over the lazy dog in line 691
 * 692: the quick brown fox jumps over the lazy dog in line 692
 * 693: the quick brown fox jumps over the lazy dog in line 693
 * 694: the quick brown fox jumps over the lazy dog in line 694
 * 695: the quick brown fox jumps over the lazy dog in line 695
 * 696: the quick brown fox jumps over the lazy dog in line 696
 * 697: the quick brown fox jumps over the lazy dog in line 697
 * 698: the quick brown fox jumps over the lazy dog in line 698
 * 699: the quick brown fox jumps over the lazy dog in line 699
 * 700: the quick brown fox jumps over the lazy dog in line 700
 * 701: the quick brown fox jumps over the lazy dog in line 701
 * 702: the quick brown fox jumps over the lazy dog in line 702
 * 703: the quick brown fox jumps over the lazy dog in line 703
 * 704: the quick brown fox jumps over the lazy dog in line 704
 * 705: the quick brown fox jumps over the lazy dog in line 705
 * 706: the quick brown fox jumps over the lazy dog in line 706
 * 707: the quick brown fox jumps over the lazy dog in line 707
 * 708: the quick brown fox jumps over the lazy dog in line 708
 * 709: the quick brown fox jumps over the lazy dog in line 709
 * 710: the quick brown fox jumps over the lazy dog in line 710
 * 711: the quick brown fox jumps over the lazy dog in line 711
 * 712: the quick brown fox jumps over the lazy dog in line 712
 * 713: the quick brown fox jumps over the lazy dog in line 713
 * 714: the quick brown fox jumps over the lazy dog in line 714
 * 715: the quick brown fox jumps over the lazy dog in line 715
 * 716: the quick brown fox jumps over the lazy dog in line 716
 * 717: the quick brown fox jumps over the lazy dog in line 717
 * 718: the quick brown fox jumps over the lazy dog in line 718
 * 719: the quick brown fox jumps over the lazy dog in line 719
 * 720: the quick brown fox jumps over the lazy dog in line 720
 * 721: the quick brown fox jumps over the lazy dog in line 721
 * 722: the quick brown fox jumps over the lazy dog in line 722
 * 723: the quick brown fox jumps over the lazy dog in line 723
 * 724: the quick brown fox jumps over the lazy dog in line 724
 * 725: the quick brown fox jumps over the lazy dog in line 725
 * 726: the quick brown fox jumps over the lazy dog in line 726
 * 727: the quick brown fox jumps over the lazy dog in line 727
 * 728: the quick brown fox jumps over the lazy dog in line 728
 * 729: the quick brown fox jumps over the lazy dog in line 729
 * 730: the quick brown fox jumps over the lazy dog in line 730
 * 731: the quick brown fox jumps over the lazy dog in line 731
 * 732: the quick brown fox jumps over the lazy dog in line 732
 * 733: the quick brown fox jumps over the lazy dog in line 733
 * 734: the quick brown fox jumps over the lazy dog in line 734
 * 735: the quick brown fox jumps over the lazy dog in line 735
 * 736: the quick brown fox jumps over the lazy dog in line 736
 * 737: the quick brown fox jumps over the lazy dog in line 737
 * 738: the quick brown fox jumps over the lazy dog in line 738
 * 739: the quick brown fox jumps over the lazy dog in line 739
 * 740: the quick brown fox jumps over the lazy dog in line 740
 * 741: the quick brown fox jumps over the lazy dog in line 741
 * 742: the quick brown fox jumps over the lazy dog in line 742
 * 743: the quick brown fox jumps over the lazy dog in line 743
 * 744: the quick brown fox jumps over the lazy dog in line 744
 * 745: the quick brown fox jumps over the lazy dog in line 745
 * 746: the quick brown fox jumps over the lazy dog in line 746
 * 747: the quick brown fox jumps over the lazy dog in line 747
 * 748: the quick brown fox jumps over the lazy dog in line 748
 * 749: the quick brown fox jumps over the lazy dog in line 749
 * 750: the quick brown fox jumps over the lazy dog in line 750
 * 751: the quick brown fox jumps over the lazy dog in line 751
 * 752: the quick brown fox jumps over the lazy dog in line 752
 * 753: the quick brown fox jumps over the lazy dog in line 753
 * 754: the quick brown fox jumps over the lazy dog in line 754
 * 755: the quick brown fox jumps over the lazy dog in line 755
 * 756: the quick brown fox jumps over the lazy dog in line 756
 * 757: the quick brown fox jumps over the lazy dog in line 757
 * 758: the quick brown fox jumps over the lazy dog in line 758
 * 759: the quick brown fox jumps over the lazy dog in line 759
 * 760: the quick brown fox jumps over the lazy dog in line 760
 * 761: the quick brown fox jumps over the lazy dog in line 761
 * 762: the quick brown fox jumps over the lazy dog in line 762
 * 763: the quick brown fox jumps over the lazy dog in line 763
 * 764: the quick brown fox jumps over the lazy dog in line 764
 * 765: the quick brown fox jumps over the lazy dog in line 765
 * 766: the quick brown fox jumps over the lazy dog in line 766
 * 767: the quick brown fox jumps over the lazy dog in line 767
 * 768: the quick brown fox jumps over the lazy dog in line 768
 * 769: the quick brown fox jumps over the lazy dog in line 769
 * 770: the quick brown fox jumps over the lazy dog in line 770
 * 771: the quick brown fox jumps over the lazy dog in line 771
 * 772: the quick brown fox jumps over the lazy dog in line 772
 * 773: the quick brown fox jumps over the lazy dog in line 773
 * 774: the quick brown fox jumps over the lazy dog in line 774
 * 775: the quick brown fox jumps over the lazy dog in line 775
 * 776: the quick brown fox jumps over the lazy dog in line 776
 * 777: the quick brown fox jumps over the lazy dog in line 777
 * 778: the quick brown fox jumps over the lazy dog in line 778
 * 779: the quick brown fox jumps over the lazy dog in line 779
 * 780: the quick brown fox jumps over the lazy dog in line 780
 * 781: the quick brown fox jumps over the lazy dog in line 781
 * 782: the quick brown fox jumps over the lazy dog in line 782
 * 783: the quick brown fox jumps over the lazy dog in line 783
 * 784: the quick brown fox jumps over the lazy dog in line 784
 * 785: the quick brown fox jumps over the lazy dog in line 785
 * 786: the quick brown fox jumps over the lazy dog in line 786
 * 787: the quick brown fox jumps over the lazy dog in line 787
 * 788: the quick brown fox jumps over the lazy dog in line 788
 * 789: the quick brown fox jumps over the lazy dog in line 789
 * 790: the quick brown fox jumps over the lazy dog in line 790
 * 791: the quick brown fox jumps over the lazy dog in line 791
 * 792: the quick brown fox jumps over the lazy dog in line 792
 * 793: the quick brown fox jumps over the lazy dog in line 793
 * 794: the quick brown fox jumps over the lazy dog in line 794
 * 795: the quick brown fox jumps over the lazy dog in line 795
 * 796: the quick brown fox jumps over the lazy dog in line 796
 * 797: the quick brown fox jumps over the lazy dog in line 797
 * 798: the quick brown fox jumps over the lazy dog in line 798
 * 799: the quick brown fox jumps over the lazy dog in line 799
 * 800: the quick brown fox jumps over the lazy dog in line 800
 * 801: the quick brown fox jumps over the lazy dog in line 801
 * 802: the quick brown fox jumps over the lazy dog in line 802
 * 803: the quick brown fox jumps over the lazy dog in line 803
 * 804: the quick brown fox jumps over the lazy dog in line 804
 * 805: the quick brown fox jumps over the lazy dog in line 805
 * 806: the quick brown fox jumps over the lazy dog in line 806
 * 807: the quick brown fox jumps over the lazy dog in line 807
 * 808: the quick brown fox jumps over the lazy dog in line 808
 * 809: the quick brown fox jumps over the lazy dog in line 809
 * 810: the quick brown fox jumps over the lazy dog in line 810
 * 811: the quick brown fox jumps over the lazy dog in line 811
 * 812: the quick brown fox jumps over the lazy dog in line 812
 * 813: the quick brown fox jumps over the lazy dog in line 813
 * 814: the quick brown fox jumps over the lazy dog in line 814
 * 815: the quick brown fox jumps over the lazy dog in line 815
 * 816: the quick brown fox jumps over the lazy dog in line 816
 * 817: the quick brown fox jumps over the lazy dog in line 817
 * 818: the quick brown fox jumps over the lazy dog in line 818
 * 819: the quick brown fox jumps over the lazy dog in line 819
 * 820: the quick brown fox jumps over the lazy dog in line 820
 * 821: the quick brown fox jumps over the lazy dog in line 821
 * 822: the quick brown fox jumps over the lazy dog in line 822
 * 823: the quick brown fox jumps over the lazy dog in line 823
 * 824: the quick brown fox jumps over the lazy dog in line 824
 * 825: the quick brown fox jumps over the lazy dog in line 825
 * 826: the quick brown fox jumps over the lazy dog in line 826
 * 827: the quick brown fox jumps over the lazy dog in line 827
 * 828: the quick brown fox jumps over the lazy dog in line 828
 * 829: the quick brown fox jumps over the lazy dog in line 829
 * 830: the quick brown fox jumps over the lazy dog in line 830
 * 831: the quick brown fox jumps over the lazy dog in line 831
 * 832: the quick brown fox jumps over the lazy dog in line 832
 * 833: the quick brown fox jumps over the lazy dog in line 833
 * 834: the quick brown fox jumps over the lazy dog in line 834
 * 835: the quick brown fox jumps over the lazy dog in line 835
 * 836: the quick brown fox jumps over the lazy dog in line 836
 * 837: the quick brown fox jumps over the lazy dog in line 837
 * 838: the quick brown fox jumps over the lazy dog in line 838
 * 839: the quick brown fox jumps over the lazy dog in line 839
 * 840: the quick brown fox jumps over the lazy dog in line 840
 * 841: the quick brown fox jumps over the lazy dog in line 841
 * 842: the quick brown fox jumps over the lazy dog in line 842
 * 843: the quick brown fox jumps over the lazy dog in line 843
 * 844: the quick brown fox jumps over the lazy dog in line 844
 * 845: the quick brown fox jumps over the lazy dog in line 845
 * 846: the quick brown fox jumps over the lazy dog in line 846
 * 847: the quick brown fox jumps over the lazy dog in line 847
 * 848: the quick brown fox jumps over the lazy dog in line 848
 * 849: the quick brown fox jumps over the lazy dog in line 849
 * 850: the quick brown fox jumps over the lazy dog in line 850
 * 851: the quick brown fox jumps over the lazy dog in line 851
 * 852: the quick brown fox jumps over the lazy dog in line 852
 * 853: the quick brown fox jumps over the lazy dog in line 853
 * 854: the quick brown fox jumps over the lazy dog in line 854
 * 855: the quick brown fox jumps over the lazy dog in line 855
 * 856: the quick brown fox jumps over the lazy dog in line 856
 * 857: the quick brown fox jumps over the lazy dog in line 857
 * 858: the quick brown fox jumps over the lazy dog in line 858
 * 859: the quick brown fox jumps over the lazy dog in line 859
 * 860: the quick brown fox jumps over the lazy dog in line 860
 * 861: the quick brown fox jumps over the lazy dog in line 861
 * 862: the quick brown fox jumps over the lazy dog in line 862
 * 863: the quick brown fox jumps over the lazy dog in line 863
 * 864: the quick brown fox jumps over the lazy dog in line 864
 * 865: the quick brown fox jumps over the lazy dog in line 865
 * 866: the quick brown fox jumps over the lazy dog in line 866
 * 867: the quick brown fox jumps over the lazy dog in line 867
 * 868: the quick brown fox jumps over the lazy dog in line 868
 * 869: the quick brown fox jumps over the lazy dog in line 869
 * 870: the quick brown fox jumps over the lazy dog in line 870
 * 871: the quick brown fox jumps over the lazy dog in line 871
 * 872: the quick brown fox jumps over the lazy dog in line 872
 * 873: the quick brown fox jumps over the lazy dog in line 873
 * 874: the quick brown fox jumps over the lazy dog in line 874
 * 875: the quick brown fox jumps over the lazy dog in line 875
 * 876: the quick brown fox jumps over the lazy dog in line 876
 * 877: the quick brown fox jumps over the lazy dog in line 877
 * 878: the quick brown fox jumps over the lazy dog in line 878
 * 879: the quick brown fox jumps over the lazy dog in line 879
 * 880: the quick brown fox jumps over the lazy dog in line 880
 * 881: the quick brown fox jumps over the lazy dog in line 881
 * 882: the quick brown fox jumps over the lazy dog in line 882
 * 883: the quick brown fox jumps over the lazy dog in line 883
 * 884: the quick brown fox jumps over the lazy dog in line 884
 * 885: the quick brown fox jumps over the lazy dog in line 885
 * 886: the quick brown fox jumps over the lazy dog in line 886
 * 887: the quick brown fox jumps over the lazy dog in line 887
 * 888: the quick brown fox jumps over the lazy dog in line 888
 * 889: the quick brown fox jumps over the lazy dog in line 889
 * 890: the quick brown fox jumps over the lazy dog in line 890
 * 891: the quick brown fox jumps over the lazy dog in line 891
 * 892: the quick brown fox jumps over the lazy dog in line 892
 * 893: the quick brown fox jumps over the lazy dog in line 893
 * 894: the quick brown fox jumps over the lazy dog in line 894
 * 895: the quick brown fox jumps over the lazy dog in line 895
 * 896: the quick brown fox jumps over the lazy dog in line 896
 * 897: the quick brown fox jumps over the lazy dog in line 897
 * 898: the quick brown fox jumps over the lazy dog in line 898
 * 899: the quick brown fox jumps over the lazy dog in line 899
 * 900: the quick brown fox jumps over the lazy dog in line 900
 * 901: the quick brown fox jumps over the lazy dog in line 901
 * 902: the quick brown fox jumps over the lazy dog in line 902
 * 903: the quick brown fox jumps over the lazy dog in line 903
 * 904: the quick brown fox jumps over the lazy dog in line 904
 * 905: the quick brown fox jumps over the lazy dog in line 905
 * 906: the quick brown fox jumps over the lazy dog in line 906
 * 907: the quick brown fox jumps over the lazy dog in line 907
 * 908: the quick brown fox jumps over the lazy dog in line 908
 * 909: the quick brown fox jumps over the lazy dog in line 909
 * 910: the quick brown fox jumps over the lazy dog in line 910
 * 911: the quick brown fox jumps over the lazy dog in line 911
 * 912: the quick brown fox jumps over the lazy dog in line 912
 * 913: the quick brown fox jumps over the lazy dog in line 913
 * 914: the quick brown fox jumps over the lazy dog in line 914
 * 915: the quick brown fox jumps over the lazy dog in line 915
 * 916: the quick brown fox jumps over the lazy dog in line 916
 * 917: the quick brown fox jumps over the lazy dog in line 917
 * 918: the quick brown fox jumps over the lazy dog in line 918
 * 919: the quick brown fox jumps over the lazy dog in line 919
 * 920: the quick brown fox jumps over the lazy dog in line 920
 * 921: the quick brown fox jumps over the lazy dog in line 921
 * 922: the quick brown fox jumps over the lazy dog in line 922
 * 923: the quick brown fox jumps over the lazy dog in line 923
 * 924: the quick brown fox jumps over the lazy dog in line 924
 * 925: the quick brown fox jumps over the lazy dog in line 925
 * 926: the quick brown fox jumps over the lazy dog in line 926
 * 927: the quick brown fox jumps over the lazy dog in line 927
 * 928: the quick brown fox jumps over the lazy dog in line 928
 * 929: the quick brown fox jumps over the lazy dog in line 929
 * 930: the quick brown fox jumps over the lazy dog in line 930
 * 931: the quick brown fox jumps over the lazy dog in line 931
 * 932: the quick brown fox jumps over the lazy dog in line 932
 * 933: the quick brown fox jumps over the lazy dog in line 933
 * 934: the quick brown fox jumps over the lazy dog in line 934
 * 935: the quick brown fox jumps over the lazy dog in line 935
 * 936: the quick brown fox jumps over the lazy dog in line 936
 * 937: the quick brown fox jumps over the lazy dog in line 937
 * 938: the quick brown fox jumps over the lazy dog in line 938
 * 939: the quick brown fox jumps over the lazy dog in line 939
 * 940: the quick brown fox jumps over the lazy dog in line 940
 * 941: the quick brown fox jumps over the lazy dog in line 941
 * 942: the quick brown fox jumps over the lazy dog in line 942
 * 943: the quick brown fox jumps over the lazy dog in line 943
 * 944: the quick brown fox jumps over the lazy dog in line 944
 * 945: the quick brown fox jumps over the lazy dog in line 945
 * 946: the quick brown fox jumps over the lazy dog in line 946
 * 947: the quick brown fox jumps over the lazy dog in line 947
 * 948: the quick brown fox jumps over the lazy dog in line 948
 * 949: the quick brown fox jumps over the lazy dog in line 949
 * 950: the quick brown fox jumps over the lazy dog in line 950
 * 951: the quick brown fox jumps over the lazy dog in line 951
 * 952: the quick brown fox jumps over the lazy dog in line 952
 * 953: the quick brown fox jumps over the lazy dog in line 953
 * 954: the quick brown fox jumps over the lazy dog in line 954
 * 955: the quick brown fox jumps over the lazy dog in line 955
 * 956: the quick brown fox jumps over the lazy dog in line 956
 * 957: the quick brown fox jumps over the lazy dog in line 957
 * 958: the quick brown fox jumps over the lazy dog in line 958
 * 959: the quick brown fox jumps over the lazy dog in line 959
 * 960: the quick brown fox jumps over the lazy dog in line 960
 * 961: the quick brown fox jumps over the lazy dog in line 961
 * 962: the quick brown fox jumps over the lazy dog in line 962
 * 963: the quick brown fox jumps over the lazy dog in line 963
 * 964: the quick brown fox jumps over the lazy dog in line 964
 * 965: the quick brown fox jumps over the lazy dog in line 965
 * 966: the quick brown fox jumps over the lazy dog in line 966
 * 967: the quick brown fox jumps over the lazy dog in line 967
 * 968: the quick brown fox jumps over the lazy dog in line 968
 * 969: the quick brown fox jumps over the lazy dog in line 969
 * 970: the quick brown fox jumps over the lazy dog in line 970
 * 971: the quick brown fox jumps over the lazy dog in line 971
 * 972: the quick brown fox jumps over the lazy dog in line 972
 * 973: the quick brown fox jumps over the lazy dog in line 973
 * 974: the quick brown fox jumps over the lazy dog in line 974
 * 975: the quick brown fox jumps over the lazy dog in line 975
 * 976: the quick brown fox jumps over the lazy dog in line 976
 * 977: the quick brown fox jumps over the lazy dog in line 977
 * 978: the quick brown fox jumps over the lazy dog in line 978
 * 979: the quick brown fox jumps over the lazy dog in line 979
 * 980: the quick brown fox jumps over the lazy dog in line 980
 * 981: the quick brown fox jumps over the lazy dog in line 981
 * 982: the quick brown fox jumps over the lazy dog in line 982
 * 983: the quick brown fox jumps over the lazy dog in line 983
 * 984: the quick brown fox jumps over the lazy dog in line 984
 * 985: the quick brown fox jumps over the lazy dog in line 985
 * 986: the quick brown fox jumps over the lazy dog in line 986
 * 987: the quick brown fox jumps over the lazy dog in line 987
 * 988: the quick brown fox jumps over the lazy dog in line 988
 * 989: the quick brown fox jumps over the lazy dog in line 989
 * 990: the quick brown fox jumps over the lazy dog in line 990
 * 991: the quick brown fox jumps over the lazy dog in line 991
 * 992: the quick brown fox jumps over the lazy dog in line 992
 * 993: the quick brown fox jumps over the lazy dog in line 993
 * 994: the quick brown fox jumps over the lazy dog in line 994
 * 995: the quick brown fox jumps over the lazy dog in line 995
 * 996: the quick brown fox jumps over the lazy dog in line 996
 * 997: the quick brown fox jumps over the lazy dog in line 997
 * 998: the quick brown fox jumps over the lazy dog in line 998
 * 999: the quick brown fox jumps over the lazy dog in line 999
 * 1000: the quick brown fox jumps over the lazy dog in line 1000
 * 1001: the quick brown fox jumps over the lazy dog in line 1001
 * 1002: the quick brown fox jumps over the lazy dog in line 1002
 * 1003: the quick brown fox jumps over the lazy dog in line 1003
 * 1004: the quick brown fox jumps over the lazy dog in line 1004
 * 1005: the quick brown fox jumps over the lazy dog in line 1005
 * 1006: the quick brown fox jumps over the lazy dog in line 1006
 * 1007: the quick brown fox jumps over the lazy dog in line 1007
 * 1008: the quick brown fox jumps over the lazy dog in line 1008
 * 1009: the quick brown fox jumps over the lazy dog in line 1009
 * 1010: the quick brown fox jumps over the lazy dog in line 1010
 * 1011: the quick brown fox jumps over the lazy dog in line 1011
 * 1012: the quick brown fox jumps over the lazy dog in line 1012
 * 1013: the quick brown fox jumps over the lazy dog in line 1013
 * 1014: the quick brown fox jumps over the lazy dog in line 1014
 * 1015: the quick brown fox jumps over the lazy dog in line 1015
 * 1016: the quick brown fox jumps over the lazy dog in line 1016
 * 1017: the quick brown fox jumps over the lazy dog in line 1017
 * 1018: the quick brown fox jumps over the lazy dog in line 1018
 * 1019: the quick brown fox jumps over the lazy dog in line 1019
 * 1020: the quick brown fox jumps over the lazy dog in line 1020
 * 1021: the quick brown fox jumps over the lazy dog in line 1021
 * 1022: the quick brown fox jumps over the lazy dog in line 1022
 * 1023: the quick brown fox jumps over the lazy dog in line 1023
 * 1024: the quick brown fox jumps over the lazy dog in line 1024
 * 1025: the quick brown fox jumps over the lazy dog in line 1025
 * 1026: the quick brown fox jumps over the lazy dog in line 1026
 * 1027: the quick brown fox jumps over the lazy dog in line 1027
 * 1028: the quick brown fox jumps over the lazy dog in line 1028
 * 1029: the quick brown fox jumps over the lazy dog in line 1029
 * 1030: the quick brown fox jumps over the lazy dog in line 1030
 * 1031: the quick brown fox jumps over the lazy dog in line 1031
 * 1032: the quick brown fox jumps over the lazy dog in line 1032
 * 1033: the quick brown fox jumps over the lazy dog in line 1033
 * 1034: the quick brown fox jumps over the lazy dog in line 1034
 * 1035: the quick brown fox jumps over the lazy dog in line 1035
 * 1036: the quick brown fox jumps over the lazy dog in line 1036
 * 1037: the quick brown fox jumps over the lazy dog in line 1037
 * 1038: the quick brown fox jumps over the lazy dog in line 1038
 * 1039: the quick brown fox jumps over the lazy dog in line 1039
 * 1040: the quick brown fox jumps over the lazy dog in line 1040
 * 1041: the quick brown fox jumps over the lazy dog in line 1041
 * 1042: the quick brown fox jumps over the lazy dog in line 1042
 * 1043: the quick brown fox jumps over the lazy dog in line 1043
 * 1044: the quick brown fox jumps over the lazy dog in line 1044
 * 1045: the quick brown fox jumps over the lazy dog in line 1045
 * 1046: the quick brown fox jumps over the lazy dog in line 1046
 * 1047: the quick brown fox jumps over the lazy dog in line 1047
 * 1048: the quick brown fox jumps over the lazy dog in line 1048
 * 1049: the quick brown fox jumps over the lazy dog in line 1049
 * 1050: the quick brown fox jumps over the lazy dog in line 1050
 * 1051: the quick brown fox jumps over the lazy dog in line 1051
 * 1052: the quick brown fox jumps over the lazy dog in line 1052
 * 1053: the quick brown fox jumps over the lazy dog in line 1053
 * 1054: the quick brown fox jumps over the lazy dog in line 1054
 * 1055: the quick brown fox jumps over the lazy dog in line 1055
 * 1056: the quick brown fox jumps over the lazy dog in line 1056
 * 1057: the quick brown fox jumps over the lazy dog in line 1057
 * 1058: the quick brown fox jumps over the lazy dog in line 1058
 * 1059: the quick brown fox jumps over the lazy dog in line 1059
 * 1060: the quick brown fox jumps over the lazy dog in line 1060
 * 1061: the quick brown fox jumps over the lazy dog in line 1061
 * 1062: the quick brown fox jumps over the lazy dog in line 1062
 * 1063: the quick brown fox jumps over the lazy dog in line 1063
 * 1064: the quick brown fox jumps over the lazy dog in line 1064
 * 1065: the quick brown fox jumps over the lazy dog in line 1065
 * 1066: the quick brown fox jumps over the lazy dog in line 1066
 * 1067: the quick brown fox jumps over the lazy dog in line 1067
 * 1068: the quick brown fox jumps over the lazy dog in line 1068
 * 1069: the quick brown fox jumps over the lazy dog in line 1069
 * 1070: the quick brown fox jumps over the lazy dog in line 1070
 * 1071: the quick brown fox jumps over the lazy dog in line 1071
 * 1072: the quick brown fox jumps over the lazy dog in line 1072
 * 1073: the quick brown fox jumps over the lazy dog in line 1073
 * 1074: the quick brown fox jumps over the lazy dog in line 1074
 * 1075: the quick brown fox jumps over the lazy dog in line 1075
 * 1076: the quick brown fox jumps over the lazy dog in line 1076
 * 1077: the quick brown fox jumps over the lazy dog in line 1077
 * 1078: the quick brown fox jumps over the lazy dog in line 1078
 * 1079: the quick brown fox jumps over the lazy dog in line 1079
 * 1080: the quick brown fox jumps over the lazy dog in line 1080
 * 1081: the quick brown fox jumps over the lazy dog in line 1081
 * 1082: the quick brown fox jumps over the lazy dog in line 1082
 * 1083: the quick brown fox jumps over the lazy dog in line 1083
 * 1084: the quick brown fox jumps over the lazy dog in line 1084
 * 1085: the quick brown fox jumps over the lazy dog in line 1085
 * 1086: the quick brown fox jumps over the lazy dog in line 1086
 * 1087: the quick brown fox jumps over the lazy dog in line 1087
 * 1088: the quick brown fox jumps over the lazy dog in line 1088
 * 1089: the quick brown fox jumps over the lazy dog in line 1089
 * 1090: the quick brown fox jumps over the lazy dog in line 1090
 * 1091: the quick brown fox jumps over the lazy dog in line 1091
 * 1092: the quick brown fox jumps over the lazy dog in line 1092
 * 1093: the quick brown fox jumps over the lazy dog in line 1093
 * 1094: the quick brown fox jumps over the lazy dog in line 1094
 * 1095: the quick brown fox jumps over the lazy dog in line 1095
 * 1096: the quick brown fox jumps over the lazy dog in line 1096
 * 1097: the quick brown fox jumps over the lazy dog in line 1097
 * 1098: the quick brown fox jumps over the lazy dog in line 1098
 * 1099: the quick brown fox jumps over the lazy dog in line 1099
 * 1100: the quick brown fox jumps over the lazy dog in line 1100
 * 1101: the quick brown fox jumps over the lazy dog in line 1101
 * 1102: the quick brown fox jumps over the lazy dog in line 1102
 * 1103: the quick brown fox jumps over the lazy dog in line 1103
 * 1104: the quick brown fox jumps over the lazy dog in line 1104
 * 1105: the quick brown fox jumps over the lazy dog in line 1105
 * 1106: the quick brown fox jumps over the lazy dog in line 1106
 * 1107: the quick brown fox jumps over the lazy dog in line 1107
 * 1108: the quick brown fox jumps over the lazy dog in line 1108
 * 1109: the quick brown fox jumps over the lazy dog in line 1109
 * 1110: the quick brown fox jumps over the lazy dog in line 1110
 * 1111: the quick brown fox jumps over the lazy dog in line 1111
 * 1112: the quick brown fox jumps over the lazy dog in line 1112
 * 1113: the quick brown fox jumps over the lazy dog in line 1113
 * 1114: the quick brown fox jumps over the lazy dog in line 1114
 * 1115: the quick brown fox jumps over the lazy dog in line 1115
 * 1116: the quick brown fox jumps over the lazy dog in line 1116
 * 1117: the quick brown fox jumps over the lazy dog in line 1117
 * 1118: the quick brown fox jumps over the lazy dog in line 1118
 * 1119: the quick brown fox jumps over the lazy dog in line 1119
 * 1120: the quick brown fox jumps over the lazy dog in line 1120
 * 1121: the quick brown fox jumps over the lazy dog in line 1121
 * 1122: the quick brown fox jumps over the lazy dog in line 1122
 * 1123: the quick brown fox jumps over the lazy dog in line 1123
 * 1124: the quick brown fox jumps over the lazy dog in line 1124
 * 1125: the quick brown fox jumps over the lazy dog in line 1125
 * 1126: the quick brown fox jumps over the lazy dog in line 1126
 * 1127: the quick brown fox jumps over the lazy dog in line 1127
 * 1128: the quick brown fox jumps over the lazy dog in line 1128
 * 1129: the quick brown fox jumps over the lazy dog in line 1129
 * 1130: the quick brown fox jumps over the lazy dog in line 1130
 * 1131: the quick brown fox jumps over the lazy dog in line 1131
 * 1132: the quick brown fox jumps over the lazy dog in line 1132
 * 1133: the quick brown fox jumps over the lazy dog in line 1133
 * 1134: the quick brown fox jumps over the lazy dog in line 1134
 * 1135: the quick brown fox jumps over the lazy dog in line 1135
 * 1136: the quick brown fox jumps over the lazy dog in line 1136
 * 1137: the quick brown fox jumps over the lazy dog in line 1137
 * 1138: the quick brown fox jumps over the lazy dog in line 1138
 * 1139: the quick brown fox jumps over the lazy dog in line 1139
 * 1140: the quick brown fox jumps over the lazy dog in line 1140
 * 1141: the quick brown fox jumps over the lazy dog in line 1141
 * 1142: the quick brown fox jumps over the lazy dog in line 1142
 * 1143: the quick brown fox jumps over the lazy dog in line 1143
 * 1144: the quick brown fox jumps over the lazy dog in line 1144
 * 1145: the quick brown fox jumps over the lazy dog in line 1145
 * 1146: the quick brown fox jumps over the lazy dog in line 1146
 * 1147: the quick brown fox jumps over the lazy dog in line 1147
 * 1148: the quick brown fox jumps over the lazy dog in line 1148
 * 1149: the quick brown fox jumps over the lazy dog in line 1149
 * 1150: the quick brown fox jumps over the lazy dog in line 1150
 * 1151: the quick brown fox jumps over the lazy dog in line 1151
 * 1152: the quick brown fox jumps over the lazy dog in line 1152
 * 1153: the quick brown fox jumps over the lazy dog in line 1153
 * 1154: the quick brown fox jumps over the lazy dog in line 1154
 * 1155: the quick brown fox jumps over the lazy dog in line 1155
 * 1156: the quick brown fox jumps over the lazy dog in line 1156
 * 1157: the quick brown fox jumps over the lazy dog in line 1157
 * 1158: the quick brown fox jumps over the lazy dog in line 1158
 * 1159: the quick brown fox jumps over the lazy dog in line 1159
 * 1160: the quick brown fox jumps over the lazy dog in line 1160
 * 1161: the quick brown fox jumps over the lazy dog in line 1161
 * 1162: the quick brown fox jumps over the lazy dog in line 1162
 * 1163: the quick brown fox jumps over the lazy dog in line 1163
 * 1164: the quick brown fox jumps over the lazy dog in line 1164
 * 1165: the quick brown fox jumps over the lazy dog in line 1165
 * 1166: the quick brown fox jumps over the lazy dog in line 1166
 * 1167: the quick brown fox jumps over the lazy dog in line 1167
 * 1168: the quick brown fox jumps over the lazy dog in line 1168
 * 1169: the quick brown fox jumps over the lazy dog in line 1169
 * 1170: the quick brown fox jumps over the lazy dog in line 1170
 * 1171: the quick brown fox jumps over the lazy dog in line 1171
 * 1172: the quick brown fox jumps over the lazy dog in line 1172
 * 1173: the quick brown fox jumps over the lazy dog in line 1173
 * 1174: the quick brown fox jumps over the lazy dog in line 1174
 * 1175: the quick brown fox jumps over the lazy dog in line 1175
 * 1176: the quick brown fox jumps over the lazy dog in line 1176
 * 1177: the quick brown fox jumps over the lazy dog in line 1177
 * 1178: the quick brown fox jumps over the lazy dog in line 1178
 * 1179: the quick brown fox jumps over the lazy dog in line 1179
 * 1180: the quick brown fox jumps over the lazy dog in line 1180
 * 1181: the quick brown fox jumps over the lazy dog in line 1181
 * 1182: the quick brown fox jumps over the lazy dog in line 1182
 * 1183: the quick brown fox jumps over the lazy dog in line 1183
 * 1184: the quick brown fox jumps over the lazy dog in line 1184
 * 1185: the quick brown fox jumps over the lazy dog in line 1185
 * 1186: the quick brown fox jumps over the lazy dog in line 1186
 * 1187: the quick brown fox jumps over the lazy dog in line 1187
 * 1188: the quick brown fox jumps over the lazy dog in line 1188
 * 1189: the quick brown fox jumps over the lazy dog in line 1189
 * 1190: the quick brown fox jumps over the lazy dog in line 1190
 * 1191: the quick brown fox jumps over the lazy dog in line 1191
 * 1192: the quick brown fox jumps over the lazy dog in line 1192
 * 1193: the quick brown fox jumps over the lazy dog in line 1193
 * 1194: the quick brown fox jumps over the lazy dog in line 1194
 * 1195: the quick brown fox jumps over the lazy dog in line 1195
 * 1196: the quick brown fox jumps over the lazy dog in line 1196
 * 1197: the quick brown fox jumps over the lazy dog in line 1197
 * 1198: the quick brown fox jumps over the lazy dog in line 1198
 * 1199: the quick brown fox jumps over the lazy dog in line 1199
 * 1200: the quick brown fox jumps over the lazy dog in line 1200
 * 1201: the quick brown fox jumps over the lazy dog in line 1201
 * 1202: the quick brown fox jumps over the lazy dog in line 1202
 * 1203: the quick brown fox jumps over the lazy dog in line 1203
 * 1204: the quick brown fox jumps over the lazy dog in line 1204
 * 1205: the quick brown fox jumps over the lazy dog in line 1205
 * 1206: the quick brown fox jumps over the lazy dog in line 1206
 * 1207: the quick brown fox jumps over the lazy dog in line 1207
 * 1208: the quick brown fox jumps over the lazy dog in line 1208
 * 1209: the quick brown fox jumps over the lazy dog in line 1209
 * 1210: the quick brown fox jumps over the lazy dog in line 1210
 * 1211: the quick brown fox jumps over the lazy dog in line 1211
 * 1212: the quick brown fox jumps over the lazy dog in line 1212
 * 1213: the quick brown fox jumps over the lazy dog in line 1213
 * 1214: the quick brown fox jumps over the lazy dog in line 1214
 * 1215: the quick brown fox jumps over the lazy dog in line 1215
 * 1216: the quick brown fox jumps over the lazy dog in line 1216
 * 1217: the quick brown fox jumps over the lazy dog in line 1217
 * 1218: the quick brown fox jumps over the lazy dog in line 1218
 * 1219: the quick brown fox jumps over the lazy dog in line 1219
 * 1220: the quick brown fox jumps over the lazy dog in line 1220
 * 1221: the quick brown fox jumps over the lazy dog in line 1221
 * 1222: the quick brown fox jumps over the lazy dog in line 1222
 * 1223: the quick brown fox jumps over the lazy dog in line 1223
 * 1224: the quick brown fox jumps over the lazy dog in line 1224
 * 1225: the quick brown fox jumps over the lazy dog in line 1225
 * 1226: the quick brown fox jumps over the lazy dog in line 1226
 * 1227: the quick brown fox jumps over the lazy dog in line 1227
 * 1228: the quick brown fox jumps over the lazy dog in line 1228
 * 1229: the quick brown fox jumps over the lazy dog in line 1229
 * 1230: the quick brown fox jumps over the lazy dog in line 1230
 * 1231: the quick brown fox jumps over the lazy dog in line 1231
 * 1232: the quick brown fox jumps over the lazy dog in line 1232
 * 1233: the quick brown fox jumps over the lazy dog in line 1233
 * 1234: the quick brown fox jumps over the lazy dog in line 1234
 * 1235: the quick brown fox jumps over the lazy dog in line 1235
 * 1236: the quick brown fox jumps over the lazy dog in line 1236
 * 1237: the quick brown fox jumps over the lazy dog in line 1237
 * 1238: the quick brown fox jumps over the lazy dog in line 1238
 * 1239: the quick brown fox jumps over the lazy dog in line 1239
 * 1240: the quick brown fox jumps over the lazy dog in line 1240
 * 1241: the quick brown fox jumps over the lazy dog in line 1241
 * 1242: the quick brown fox jumps over the lazy dog in line 1242
 * 1243: the quick brown fox jumps over the lazy dog in line 1243
 * 1244: the quick brown fox jumps over the lazy dog in line 1244
 * 1245: the quick brown fox jumps over the lazy dog in line 1245
 * 1246: the quick brown fox jumps over the lazy dog in line 1246
 * 1247: the quick brown fox jumps over the lazy dog in line 1247
 * 1248: the quick brown fox jumps over the lazy dog in line 1248
 * 1249: the quick brown fox jumps over the lazy dog in line 1249
 * 1250: the quick brown fox jumps over the lazy dog in line 1250
 * 1251: the quick brown fox jumps over the lazy dog in line 1251
 * 1252: the quick brown fox jumps over the lazy dog in line 1252
 * 1253: the quick brown fox jumps over the lazy dog in line 1253
 * 1254: the quick brown fox jumps over the lazy dog in line 1254
 * 1255: the quick brown fox jumps over the lazy dog in line 1255
 * 1256: the quick brown fox jumps over the lazy dog in line 1256
 * 1257: the quick brown fox jumps over the lazy dog in line 1257
 * 1258: the quick brown fox jumps over the lazy dog in line 1258
 * 1259: the quick brown fox jumps over the lazy dog in line 1259
 * 1260: the quick brown fox jumps over the lazy dog in line 1260
 * 1261: the quick brown fox jumps over the lazy dog in line 1261
 * 1262: the quick brown fox jumps over the lazy dog in line 1262
 * 1263: the quick brown fox jumps over the lazy dog in line 1263
 * 1264: the quick brown fox jumps over the lazy dog in line 1264
 * 1265: the quick brown fox jumps over the lazy dog in line 1265
 * 1266: the quick brown fox jumps over the lazy dog in line 1266
 * 1267: the quick brown fox jumps over the lazy dog in line 1267
 * 1268: the quick brown fox jumps over the lazy dog in line 1268
 * 1269: the quick brown fox jumps over the lazy dog in line 1269
 * 1270: the quick brown fox jumps over the lazy dog in line 1270
 * 1271: the quick brown fox jumps over the lazy dog in line 1271
 * 1272: the quick brown fox jumps over the lazy dog in line 1272
 * 1273: the quick brown fox jumps over the lazy dog in line 1273
 * 1274: the quick brown fox jumps over the lazy dog in line 1274
 * 1275: the quick brown fox jumps over the lazy dog in line 1275
 * 1276: the quick brown fox jumps over the lazy dog in line 1276
 * 1277: the quick brown fox jumps over the lazy dog in line 1277
 * 1278: the quick brown fox jumps over the lazy dog in line 1278
 * 1279: the quick brown fox jumps over the lazy dog in line 1279
 * 1280: the quick brown fox jumps over the lazy dog in line 1280
 * 1281: the quick brown fox jumps over the lazy dog in line 1281
 * 1282: the quick brown fox jumps over the lazy dog in line 1282
 * 1283: the quick brown fox jumps over the lazy dog in line 1283
 * 1284: the quick brown fox jumps over the lazy dog in line 1284
 * 1285: the quick brown fox jumps over the lazy dog in line 1285
 * 1286: the quick brown fox jumps over the lazy dog in line 1286
 * 1287: the quick brown fox jumps over the lazy dog in line 1287
 * 1288: the quick brown fox jumps over the lazy dog in line 1288
 * 1289: the quick brown fox jumps over the lazy dog in line 1289
 * 1290: the quick brown fox jumps over the lazy dog in line 1290
 * 1291: the quick brown fox jumps over the lazy dog in line 1291
 * 1292: the quick brown fox jumps over the lazy dog in line 1292
 * 1293: the quick brown fox jumps over the lazy dog in line 1293
 * 1294: the quick brown fox jumps over the lazy dog in line 1294
 * 1295: the quick brown fox jumps over the lazy dog in line 1295
 * 1296: the quick brown fox jumps over the lazy dog in line 1296
 * 1297: the quick brown fox jumps over the lazy dog in line 1297
 * 1298: the quick brown fox jumps over the lazy dog in line 1298
 * 1299: the quick brown fox jumps over the lazy dog in line 1299
 * 1300: the quick brown fox jumps over the lazy dog in line 1300
 * 1301: the quick brown fox jumps over the lazy dog in line 1301
 * 1302: the quick brown fox jumps over the lazy dog in line 1302
 * 1303: the quick brown fox jumps over the lazy dog in line 1303
 * 1304: the quick brown fox jumps over the lazy dog in line 1304
 * 1305: the quick brown fox jumps over the lazy dog in line 1305
 * 1306: the quick brown fox jumps over the lazy dog in line 1306
 * 1307: the quick brown fox jumps over the lazy dog in line 1307
 * 1308: the quick brown fox jumps over the lazy dog in line 1308
 * 1309: the quick brown fox jumps over the lazy dog in line 1309
 * 1310: the quick brown fox jumps over the lazy dog in line 1310
 * 1311: the quick brown fox jumps over the lazy dog in line 1311
 * 1312: the quick brown fox jumps over the lazy dog in line 1312
 * 1313: the quick brown fox jumps over the lazy dog in line 1313
 * 1314: the quick brown fox jumps over the lazy dog in line 1314
 * 1315: the quick brown fox jumps over the lazy dog in line 1315
 * 1316: the quick brown fox jumps over the lazy dog in line 1316
 * 1317: the quick brown fox jumps over the lazy dog in line 1317
 * 1318: the quick brown fox jumps over the lazy dog in line 1318
 * 1319: the quick brown fox jumps over the lazy dog in line 1319
 * 1320: the quick brown fox jumps over the lazy dog in line 1320
 * 1321: the quick brown fox jumps over the lazy dog in line 1321
 * 1322: the quick brown fox jumps over the lazy dog in line 1322
 * 1323: the quick brown fox jumps over the lazy dog in line 1323
 * 1324: the quick brown fox jumps over the lazy dog in line 1324
 * 1325: the quick brown fox jumps over the lazy dog in line 1325
 * 1326: the quick brown fox jumps over the lazy dog in line 1326
 * 1327: the quick brown fox jumps over the lazy dog in line 1327
 * 1328: the quick brown fox jumps over the lazy dog in line 1328
 * 1329: the quick brown fox jumps over the lazy dog in line 1329
 * 1330: the quick brown fox jumps over the lazy dog in line 1330
 * 1331: the quick brown fox jumps over the lazy dog in line 1331
 * 1332: the quick brown fox jumps over the lazy dog in line 1332
 * 1333: the quick brown fox jumps over the lazy dog in line 1333
 * 1334: the quick brown fox jumps over the lazy dog in line 1334
 * 1335: the quick brown fox jumps over the lazy dog in line 1335
 * 1336: the quick brown fox jumps over the lazy dog in line 1336
 * 1337: the quick brown fox jumps over the lazy dog in line 1337
 * 1338: the quick brown fox jumps over the lazy dog in line 1338
 * 1339: the quick brown fox jumps over the lazy dog in line 1339
 * 1340: the quick brown fox jumps over the lazy dog in line 1340
 * 1341: the quick brown fox jumps over the lazy dog in line 1341
 * 1342: the quick brown fox jumps over the lazy dog in line 1342
 * 1343: the quick brown fox jumps over the lazy dog in line 1343
 * 1344: the quick brown fox jumps over the lazy dog in line 1344
 * 1345: the quick brown fox jumps over the lazy dog in line 1345
 * 1346: the quick brown fox jumps over the lazy dog in line 1346
 * 1347: the quick brown fox jumps over the lazy dog in line 1347
 * 1348: the quick brown fox jumps over the lazy dog in line 1348
 * 1349: the quick brown fox jumps over the lazy dog in line 1349
 * 1350: the quick brown fox jumps over the lazy dog in line 1350
 * 1351: the quick brown fox jumps over the lazy dog in line 1351
 * 1352: the quick brown fox jumps over the lazy dog in line 1352
 * 1353: the quick brown fox jumps over the lazy dog in line 1353
 * 1354: the quick brown fox jumps over the lazy dog in line 1354
 * 1355: the quick brown fox jumps over the lazy dog in line 1355
 * 1356: the quick brown fox jumps over the lazy dog in line 1356
 * 1357: the quick brown fox jumps over the lazy dog in line 1357
 * 1358: the quick brown fox jumps over the lazy dog in line 1358
 * 1359: the quick brown fox jumps over the lazy dog in line 1359
 * 1360: the quick brown fox jumps over the lazy dog in line 1360
 * 1361: the quick brown fox jumps over the lazy dog in line 1361
 * 1362: the quick brown fox jumps over the lazy dog in line 1362
 * 1363: the quick brown fox jumps over the lazy dog in line 1363
 * 1364: the quick brown fox jumps over the lazy dog in line 1364
 * 1365: the quick brown fox jumps over the lazy dog in line 1365
 * 1366: the quick brown fox jumps over the lazy dog in line 1366
 * 1367: the quick brown fox jumps over the lazy dog in line 1367
 * 1368: the quick brown fox jumps over the lazy dog in line 1368
 * 1369: the quick brown fox jumps over the lazy dog in line 1369
 * 1370: the quick brown fox jumps over the lazy dog in line 1370
 * 1371: the quick brown fox jumps over the lazy dog in line 1371
 * 1372: the quick brown fox jumps over the lazy dog in line 1372
 * 1373: the quick brown fox jumps over the lazy dog in line 1373
 * 1374: the quick brown fox jumps over the lazy dog in line 1374
 * 1375: the quick brown fox jumps over the lazy dog in line 1375
 * 1376: the quick brown fox jumps over the lazy dog in line 1376
 * 1377: the quick brown fox jumps over the lazy dog in line 1377
 * 1378: the quick brown fox jumps over the lazy dog in line 1378
 * 1379: the quick brown fox jumps over the lazy dog in line 1379
 * 1380: the quick brown fox jumps over the lazy dog in line 1380
 * 1381: the quick brown fox jumps over the lazy dog in line 1381
 * 1382: the quick brown fox jumps over the lazy dog in line 1382
 * 1383: the quick brown fox jumps over the lazy dog in line 1383
 * 1384: the quick brown fox jumps over the lazy dog in line 1384
 * 1385: the quick brown fox jumps over the lazy dog in line 1385
 * 1386: the quick brown fox jumps over the lazy dog in line 1386
 * 1387: the quick brown fox jumps over the lazy dog in line 1387
 * 1388: the quick brown fox jumps over the lazy dog in line 1388
 * 1389: the quick brown fox jumps over the lazy dog in line 1389
 * 1390: the quick brown fox jumps over the lazy dog in line 1390
 * 1391: the quick brown fox jumps over the lazy dog in line 1391
 * 1392: the quick brown fox jumps over the lazy dog in line 1392
 * 1393: the quick brown fox jumps over the lazy dog in line 1393
 * 1394: the quick brown fox jumps over the lazy dog in line 1394
 * 1395: the quick brown fox jumps over the lazy dog in line 1395
 * 1396: the quick brown fox jumps over the lazy dog in line 1396
 * 1397: the quick brown fox jumps over the lazy dog in line 1397
 * 1398: the quick brown fox jumps over the lazy dog in line 1398
 * 1399: the quick brown fox jumps over the lazy dog in line 1399
 * 1400: the quick brown fox jumps over the lazy dog in line 1400
 * 1401: the quick brown fox jumps over the lazy dog in line 1401
 * 1402: the quick brown fox jumps over the lazy dog in line 1402
 * 1403: the quick brown fox jumps over the lazy dog in line 1403
 * 1404: the quick brown fox jumps over the lazy dog in line 1404
 * 1405: the quick brown fox jumps over the lazy dog in line 1405
 * 1406: the quick brown fox jumps over the lazy dog in line 1406
 * 1407: the quick brown fox jumps over the lazy dog in line 1407
 * 1408: the quick brown fox jumps over the lazy dog in line 1408
 * 1409: the quick brown fox jumps over the lazy dog in line 1409
 * 1410: the quick brown fox jumps over the lazy dog in line 1410
 * 1411: the quick brown fox jumps over the lazy dog in line 1411
 * 1412: the quick brown fox jumps over the lazy dog in line 1412
 * 1413: the quick brown fox jumps over the lazy dog in line 1413
 * 1414: the quick brown fox jumps over the lazy dog in line 1414
 * 1415: the quick brown fox jumps over the lazy dog in line 1415
 * 1416: the quick brown fox jumps over the lazy dog in line 1416
 * 1417: the quick brown fox jumps over the lazy dog in line 1417
 * 1418: the quick brown fox jumps over the lazy dog in line 1418
 * 1419: the quick brown fox jumps over the lazy dog in line 1419
 * 1420: the quick brown fox jumps over the lazy dog in line 1420
 * 1421: the quick brown fox jumps over the lazy dog in line 1421
 * 1422: the quick brown fox jumps over the lazy dog in line 1422
 * 1423: the quick brown fox jumps over the lazy dog in line 1423
 * 1424: the quick brown fox jumps over the lazy dog in line 1424
 * 1425: the quick brown fox jumps over the lazy dog in line 1425
 * 1426: the quick brown fox jumps over the lazy dog in line 1426
 * 1427: the quick brown fox jumps over the lazy dog in line 1427
 * 1428: the quick brown fox jumps over the lazy dog in line 1428
 * 1429: the quick brown fox jumps over the lazy dog in line 1429
 * 1430: the quick brown fox jumps over the lazy dog in line 1430
 * 1431: the quick brown fox jumps over the lazy dog in line 1431
 * 1432: the quick brown fox jumps over the lazy dog in line 1432
 * 1433: the quick brown fox jumps over the lazy dog in line 1433
 * 1434: the quick brown fox jumps over the lazy dog in line 1434
 * 1435: the quick brown fox jumps over the lazy dog in line 1435
 * 1436: the quick brown fox jumps over the lazy dog in line 1436
 * 1437: the quick brown fox jumps over the lazy dog in line 1437
 * 1438: the quick brown fox jumps over the lazy dog in line 1438
 * 1439: the quick brown fox jumps over the lazy dog in line 1439
 * 1440: the quick brown fox jumps over the lazy dog in line 1440
 * 1441: the quick brown fox jumps over the lazy dog in line 1441
 * 1442: the quick brown fox jumps over the lazy dog in line 1442
 * 1443: the quick brown fox jumps over the lazy dog in line 1443
 * 1444: the quick brown fox jumps over the lazy dog in line 1444
 * 1445: the quick brown fox jumps over the lazy dog in line 1445
 * 1446: the quick brown fox jumps over the lazy dog in line 1446
 * 1447: the quick brown fox jumps over the lazy dog in line 1447
 * 1448: the quick brown fox jumps over the lazy dog in line 1448
 * 1449: the quick brown fox jumps over the lazy dog in line 1449
 * 1450: the quick brown fox jumps over the lazy dog in line 1450
 * 1451: the quick brown fox jumps over the lazy dog in line 1451
 * 1452: the quick brown fox jumps over the lazy dog in line 1452
 * 1453: the quick brown fox jumps over the lazy dog in line 1453
 * 1454: the quick brown fox jumps over the lazy dog in line 1454
 * 1455: the quick brown fox jumps over the lazy dog in line 1455
 * 1456: the quick brown fox jumps over the lazy dog in line 1456
 * 1457: the quick brown fox jumps over the lazy dog in line 1457
 * 1458: the quick brown fox jumps over the lazy dog in line 1458
 * 1459: the quick brown fox jumps over the lazy dog in line 1459
 * 1460: the quick brown fox jumps over the lazy dog in line 1460
 * 1461: the quick brown fox jumps over the lazy dog in line 1461
 * 1462: the quick brown fox jumps over the lazy dog in line 1462
 * 1463: the quick brown fox jumps over the lazy dog in line 1463
 * 1464: the quick brown fox jumps over the lazy dog in line 1464
 * 1465: the quick brown fox jumps over the lazy dog in line 1465
 * 1466: the quick brown fox jumps over the lazy dog in line 1466
 * 1467: the quick brown fox jumps over the lazy dog in line 1467
 * 1468: the quick brown fox jumps over the lazy dog in line 1468
 * 1469: the quick brown fox jumps over the lazy dog in line 1469
 * 1470: the quick brown fox jumps over the lazy dog in line 1470
 * 1471: the quick brown fox jumps over the lazy dog in line 1471
 * 1472: the quick brown fox jumps over the lazy dog in line 1472
 * 1473: the quick brown fox jumps over the lazy dog in line 1473
 * 1474: the quick brown fox jumps over the lazy dog in line 1474
 * 1475: the quick brown fox jumps over the lazy dog in line 1475
 * 1476: the quick brown fox jumps over the lazy dog in line 1476
 * 1477: the quick brown fox jumps over the lazy dog in line 1477
 * 1478: the quick brown fox jumps over the lazy dog in line 1478
 * 1479: the quick brown fox jumps over the lazy dog in line 1479
 * 1480: the quick brown fox jumps over the lazy dog in line 1480
 * 1481: the quick brown fox jumps over the lazy dog in line 1481
 * 1482: the quick brown fox jumps over the lazy dog in line 1482
 * 1483: the quick brown fox jumps over the lazy dog in line 1483
 * 1484: the quick brown fox jumps over the lazy dog in line 1484
 * 1485: the quick brown fox jumps over the lazy dog in line 1485
 * 1486: the quick brown fox jumps over the lazy dog in line 1486
 * 1487: the quick brown fox jumps over the lazy dog in line 1487
 * 1488: the quick brown fox jumps over the lazy dog in line 1488
 * 1489: the quick brown fox jumps over the lazy dog in line 1489
 * 1490: the quick brown fox jumps over the lazy dog in line 1490
 * 1491: the quick brown fox jumps over the lazy dog in line 1491
 * 1492: the quick brown fox jumps over the lazy dog in line 1492
 * 1493: the quick brown fox jumps over the lazy dog in line 1493
 * 1494: the quick brown fox jumps over the lazy dog in line 1494
 * 1495: the quick brown fox jumps over the lazy dog in line 1495
 * 1496: the quick brown fox jumps over the lazy dog in line 1496
 * 1497: the quick brown fox jumps over the lazy dog in line 1497
 * 1498: the quick brown fox jumps over the lazy dog in line 1498
 * 1499: the quick brown fox jumps over the lazy dog in line 1499
 * 1500: the quick brown fox jumps over the lazy dog in line 1500
 * 1501: the quick brown fox jumps over the lazy dog in line 1501
 * 1502: the quick brown fox jumps over the lazy dog in line 1502
 * 1503: the quick brown fox jumps over the lazy dog in line 1503
 * 1504: the quick brown fox jumps over the lazy dog in line 1504
 * 1505: the quick brown fox jumps over the lazy dog in line 1505
 * 1506: the quick brown fox jumps over the lazy dog in line 1506
 * 1507: the quick brown fox jumps over the lazy dog in line 1507
 * 1508: the quick brown fox jumps over the lazy dog in line 1508
 * 1509: the quick brown fox jumps over the lazy dog in line 1509
 * 1510: the quick brown fox jumps over the lazy dog in line 1510
 * 1511: the quick brown fox jumps over the lazy dog in line 1511
 * 1512: the quick brown fox jumps over the lazy dog in line 1512
 * 1513: the quick brown fox jumps over the lazy dog in line 1513
 * 1514: the quick brown fox jumps over the lazy dog in line 1514
 * 1515: the quick brown fox jumps over the lazy dog in line 1515
 * 1516: the quick brown fox jumps over the lazy dog in line 1516
 * 1517: the quick brown fox jumps over the lazy dog in line 1517
 * 1518: the quick brown fox jumps over the lazy dog in line 1518
 * 1519: the quick brown fox jumps over the lazy dog in line 1519
 * 1520: the quick brown fox jumps over the lazy dog in line 1520
 * 1521: the quick brown fox jumps over the lazy dog in line 1521
 * 1522: the quick brown fox jumps over the lazy dog in line 1522
 * 1523: the quick brown fox jumps over the lazy dog in line 1523
 * 1524: the quick brown fox jumps over the lazy dog in line 1524
 * 1525: the quick brown fox jumps over the lazy dog in line 1525
 * 1526: the quick brown fox jumps over the lazy dog in line 1526
 * 1527: the quick brown fox jumps over the lazy dog in line 1527
 * 1528: the quick brown fox jumps over the lazy dog in line 1528
 * 1529: the quick brown fox jumps over the lazy dog in line 1529
 * 1530: the quick brown fox jumps over the lazy dog in line 1530
 * 1531: the quick brown fox jumps over the lazy dog in line 1531
 * 1532: the quick brown fox jumps over the lazy dog in line 1532
 * 1533: the quick brown fox jumps over the lazy dog in line 1533
 * 1534: the quick brown fox jumps over the lazy dog in line 1534
 * 1535: the quick brown fox jumps over the lazy dog in line 1535
 * 1536: the quick brown fox jumps over the lazy dog in line 1536
 * 1537: the quick brown fox jumps over the lazy dog in line 1537
 * 1538: the quick brown fox jumps over the lazy dog in line 1538
 * 1539: the quick brown fox jumps over the lazy dog in line 1539
 * 1540: the quick brown fox jumps over the lazy dog in line 1540
 * 1541: the quick brown fox jumps over the lazy dog in line 1541
 * 1542: the quick brown fox jumps over the lazy dog in line 1542
 * 1543: the quick brown fox jumps over the lazy dog in line 1543
 * 1544: the quick brown fox jumps over the lazy dog in line 1544
 * 1545: the quick brown fox jumps over the lazy dog in line 1545
 * 1546: the quick brown fox jumps over the lazy dog in line 1546
 * 1547: the quick brown fox jumps over the lazy dog in line 1547
 * 1548: the quick brown fox jumps over the lazy dog in line 1548
 * 1549: the quick brown fox jumps over the lazy dog in line 1549
 * 1550: the quick brown fox jumps over the lazy dog in line 1550
 * 1551: the quick brown fox jumps over the lazy dog in line 1551
 * 1552: the quick brown fox jumps over the lazy dog in line 1552
 * 1553: the quick brown fox jumps over the lazy dog in line 1553
 * 1554: the quick brown fox jumps over the lazy dog in line 1554
 * 1555: the quick brown fox jumps over the lazy dog in line 1555
 * 1556: the quick brown fox jumps over the lazy dog in line 1556
 * 1557: the quick brown fox jumps over the lazy dog in line 1557
 * 1558: the quick brown fox jumps over the lazy dog in line 1558
 * 1559: the quick brown fox jumps over the lazy dog in line 1559
 * 1560: the quick brown fox jumps over the lazy dog in line 1560
 * 1561: the quick brown fox jumps over the lazy dog in line 1561
 * 1562: the quick brown fox jumps over the lazy dog in line 1562
 * 1563: the quick brown fox jumps over the lazy dog in line 1563
 * 1564: the quick brown fox jumps over the lazy dog in line 1564
 * 1565: the quick brown fox jumps over the lazy dog in line 1565
 * 1566: the quick brown fox jumps over the lazy dog in line 1566
 * 1567: the quick brown fox jumps over the lazy dog in line 1567
 * 1568: the quick brown fox jumps over the lazy dog in line 1568
 * 1569: the quick brown fox jumps over the lazy dog in line 1569
 * 1570: the quick brown fox jumps over the lazy dog in line 1570
 * 1571: the quick brown fox jumps over the lazy dog in line 1571
 * 1572: the quick brown fox jumps over the lazy dog in line 1572
 * 1573: the quick brown fox jumps over the lazy dog in line 1573
 * 1574: the quick brown fox jumps over the lazy dog in line 1574
 * 1575: the quick brown fox jumps over the lazy dog in line 1575
 * 1576: the quick brown fox jumps over the lazy dog in line 1576
 * 1577: the quick brown fox jumps over the lazy dog in line 1577
 * 1578: the quick brown fox jumps over the lazy dog in line 1578
 * 1579: the quick brown fox jumps over the lazy dog in line 1579
 * 1580: the quick brown fox jumps over the lazy dog in line 1580
 * 1581: the quick brown fox jumps over the lazy dog in line 1581
 * 1582: the quick brown fox jumps over the lazy dog in line 1582
 * 1583: the quick brown fox jumps over the lazy dog in line 1583
 * 1584: the quick brown fox jumps over the lazy dog in line 1584
 * 1585: the quick brown fox jumps over the lazy dog in line 1585
 * 1586: the quick brown fox jumps over the lazy dog in line 1586
 * 1587: the quick brown fox jumps over the lazy dog in line 1587
 * 1588: the quick brown fox jumps over the lazy dog in line 1588
 * 1589: the quick brown fox jumps over the lazy dog in line 1589
 * 1590: the quick brown fox jumps over the lazy dog in line 1590
 * 1591: the quick brown fox jumps over the lazy dog in line 1591
 * 1592: the quick brown fox jumps over the lazy dog in line 1592
 * 1593: the quick brown fox jumps over the lazy dog in line 1593
 * 1594: the quick brown fox jumps over the lazy dog in line 1594
 * 1595: the quick brown fox jumps over the lazy dog in line 1595
 * 1596: the quick brown fox jumps over the lazy dog in line 1596
 * 1597: the quick brown fox jumps over the lazy dog in line 1597
 * 1598: the quick brown fox jumps over the lazy dog in line 1598
 * 1599: the quick brown fox jumps over the lazy dog in line 1599
 * 1600: the quick brown fox jumps over the lazy dog in line 1600
 * 1601: the quick brown fox jumps over the lazy dog in line 1601
 * 1602: the quick brown fox jumps over the lazy dog in line 1602
 * 1603: the quick brown fox jumps over the lazy dog in line 1603
 * 1604: the quick brown fox jumps over the lazy dog in line 1604
 * 1605: the quick brown fox jumps over the lazy dog in line 1605
 * 1606: the quick brown fox jumps over the lazy dog in line 1606
 * 1607: the quick brown fox jumps over the lazy dog in line 1607
 * 1608: the quick brown fox jumps over the lazy dog in line 1608
 * 1609: the quick brown fox jumps over the lazy dog in line 1609
 * 1610: the quick brown fox jumps over the lazy dog in line 1610
 * 1611: the quick brown fox jumps over the lazy dog in line 1611
 * 1612: the quick brown fox jumps over the lazy dog in line 1612
 * 1613: the quick brown fox jumps over the lazy dog in line 1613
 * 1614: the quick brown fox jumps over the lazy dog in line 1614
 * 1615: the quick brown fox jumps over the lazy dog in line 1615
 * 1616: the quick brown fox jumps over the lazy dog in line 1616
 * 1617: the quick brown fox jumps over the lazy dog in line 1617
 * 1618: the quick brown fox jumps over the lazy dog in line 1618
 * 1619: the quick brown fox jumps over the lazy dog in line 1619
 * 1620: the quick brown fox jumps over the lazy dog in line 1620
 * 1621: the quick brown fox jumps over the lazy dog in line 1621
 * 1622: the quick brown fox jumps over the lazy dog in line 1622
 * 1623: the quick brown fox jumps over the lazy dog in line 1623
 * 1624: the quick brown fox jumps over the lazy dog in line 1624
 * 1625: the quick brown fox jumps over the lazy dog in line 1625
 * 1626: the quick brown fox jumps over the lazy dog in line 1626
 * 1627: the quick brown fox jumps over the lazy dog in line 1627
 * 1628: the quick brown fox jumps over the lazy dog in line 1628
 * 1629: the quick brown fox jumps over the lazy dog in line 1629
 * 1630: the quick brown fox jumps over the lazy dog in line 1630
 * 1631: the quick brown fox jumps over the lazy dog in line 1631
 * 1632: the quick brown fox jumps over the lazy dog in line 1632
 * 1633: the quick brown fox jumps over the lazy dog in line 1633
 * 1634: the quick brown fox jumps over the lazy dog in line 1634
 * 1635: the quick brown fox jumps over the lazy dog in line 1635
 * 1636: the quick brown fox jumps over the lazy dog in line 1636
 * 1637: the quick brown fox jumps over the lazy dog in line 1637
 * 1638: the quick brown fox jumps over the lazy dog in line 1638
 * 1639: the quick brown fox jumps over the lazy dog in line 1639
 * 1640: the quick brown fox jumps over the lazy dog in line 1640
 * 1641: the quick brown fox jumps over the lazy dog in line 1641
 * 1642: the quick brown fox jumps over the lazy dog in line 1642
 * 1643: the quick brown fox jumps over the lazy dog in line 1643
 * 1644: the quick brown fox jumps over the lazy dog in line 1644
 * 1645: the quick brown fox jumps over the lazy dog in line 1645
 * 1646: the quick brown fox jumps over the lazy dog in line 1646
 * 1647: the quick brown fox jumps over the lazy dog in line 1647
 * 1648: the quick brown fox jumps over the lazy dog in line 1648
 * 1649: the quick brown fox jumps over the lazy dog in line 1649
 * 1650: the quick brown fox jumps over the lazy dog in line 1650
 * 1651: the quick brown fox jumps over the lazy dog in line 1651
 * 1652: the quick brown fox jumps over the lazy dog in line 1652
 * 1653: the quick brown fox jumps over the lazy dog in line 1653
 * 1654: the quick brown fox jumps over the lazy dog in line 1654
 * 1655: the quick brown fox jumps over the lazy dog in line 1655
 * 1656: the quick brown fox jumps over the lazy dog in line 1656
 * 1657: the quick brown fox jumps over the lazy dog in line 1657
 * 1658: the quick brown fox jumps over the lazy dog in line 1658
 * 1659: the quick brown fox jumps over the lazy dog in line 1659
 * 1660: the quick brown fox jumps over the lazy dog in line 1660
 * 1661: the quick brown fox jumps over the lazy dog in line 1661
 * 1662: the quick brown fox jumps over the lazy dog in line 1662
 * 1663: the quick brown fox jumps over the lazy dog in line 1663
 * 1664: the quick brown fox jumps over the lazy dog in line 1664
 * 1665: the quick brown fox jumps over the lazy dog in line 1665
 * 1666: the quick brown fox jumps over the lazy dog in line 1666
 * 1667: the quick brown fox jumps over the lazy dog in line 1667
 * 1668: the quick brown fox jumps over the lazy dog in line 1668
 * 1669: the quick brown fox jumps over the lazy dog in line 1669
 * 1670: the quick brown fox jumps over the lazy dog in line 1670
 * 1671: the quick brown fox jumps over the lazy dog in line 1671
 * 1672: the quick brown fox jumps over the lazy dog in line 1672
 * 1673: the quick brown fox jumps over the lazy dog in line 1673
 * 1674: the quick brown fox jumps over the lazy dog in line 1674
 * 1675: the quick brown fox jumps over the lazy dog in line 1675
 * 1676: the quick brown fox jumps over the lazy dog in line 1676
 * 1677: the quick brown fox jumps over the lazy dog in line 1677
 * 1678: the quick brown fox jumps over the lazy dog in line 1678
 * 1679: the quick brown fox jumps over the lazy dog in line 1679
 * 1680: the quick brown fox jumps over the lazy dog in line 1680
 * 1681: the quick brown fox jumps over the lazy dog in line 1681
 * 1682: the quick brown fox jumps over the lazy dog in line 1682
 * 1683: the quick brown fox jumps over the lazy dog in line 1683
 * 1684: the quick brown fox jumps over the lazy dog in line 1684
 * 1685: the quick brown fox jumps over the lazy dog in line 1685
 * 1686: the quick brown fox jumps over the lazy dog in line 1686
 * 1687: the quick brown fox jumps over the lazy dog in line 1687
 * 1688: the quick brown fox jumps over the lazy dog in line 1688
 * 1689: the quick brown fox jumps over the lazy dog in line 1689
 * 1690: the quick brown fox jumps over the lazy dog in line 1690
 * 1691: the quick brown fox jumps over the lazy dog in line 1691
 * 1692: the quick brown fox jumps over the lazy dog in line 1692
 * 1693: the quick brown fox jumps over the lazy dog in line 1693
 * 1694: the quick brown fox jumps over the lazy dog in line 1694
 * 1695: the quick brown fox jumps over the lazy dog in line 1695
 * 1696: the quick brown fox jumps over the lazy dog in line 1696
 * 1697: the quick brown fox jumps over the lazy dog in line 1697
 * 1698: the quick brown fox jumps over the lazy dog in line 1698
 * 1699: the quick brown fox jumps over the lazy dog in line 1699
 * 1700: the quick brown fox jumps over the lazy dog in line 1700
 * 1701: the quick brown fox jumps over the lazy dog in line 1701
 * 1702: the quick brown fox jumps over the lazy dog in line 1702
 * 1703: the quick brown fox jumps over the lazy dog in line 1703
 * 1704: the quick brown fox jumps over the lazy dog in line 1704
 * 1705: the quick brown fox jumps over the lazy dog in line 1705
 * 1706: the quick brown fox jumps over the lazy dog in line 1706
 * 1707: the quick brown fox jumps over the lazy dog in line 1707
 * 1708: the quick brown fox jumps over the lazy dog in line 1708
 * 1709: the quick brown fox jumps over the lazy dog in line 1709
 * 1710: the quick brown fox jumps over the lazy dog in line 1710
 * 1711: the quick brown fox jumps over the lazy dog in line 1711
 * 1712: the quick brown fox jumps over the lazy dog in line 1712
 * 1713: the quick brown fox jumps over the lazy dog in line 1713
 * 1714: the quick brown fox jumps over the lazy dog in line 1714
 * 1715: the quick brown fox jumps over the lazy dog in line 1715
 * 1716: the quick brown fox jumps over the lazy dog in line 1716
 * 1717: the quick brown fox jumps over the lazy dog in line 1717
 * 1718: the quick brown fox jumps over the lazy dog in line 1718
 * 1719: the quick brown fox jumps over the lazy dog in line 1719
 * 1720: the quick brown fox jumps over the lazy dog in line 1720
 * 1721: the quick brown fox jumps over the lazy dog in line 1721
 * 1722: the quick brown fox jumps over the lazy dog in line 1722
 * 1723: the quick brown fox jumps over the lazy dog in line 1723
 * 1724: the quick brown fox jumps over the lazy dog in line 1724
 * 1725: the quick brown fox jumps over the lazy dog in line 1725
 * 1726: the quick brown fox jumps over the lazy dog in line 1726
 * 1727: the quick brown fox jumps over the lazy dog in line 1727
 * 1728: the quick brown fox jumps over the lazy dog in line 1728
 * 1729: the quick brown fox jumps over the lazy dog in line 1729
 * 1730: the quick brown fox jumps over the lazy dog in line 1730
 * 1731: the quick brown fox jumps over the lazy dog in line 1731
 * 1732: the quick brown fox jumps over the lazy dog in line 1732
 * 1733: the quick brown fox jumps over the lazy dog in line 1733
 * 1734: the quick brown fox jumps over the lazy dog in line 1734
 * 1735: the quick brown fox jumps over the lazy dog in line 1735
 * 1736: the quick brown fox jumps over the lazy dog in line 1736
 * 1737: the quick brown fox jumps over the lazy dog in line 1737
 * 1738: the quick brown fox jumps over the lazy dog in line 1738
 * 1739: the quick brown fox jumps over the lazy dog in line 1739
 * 1740: the quick brown fox jumps over the lazy dog in line 1740
 * 1741: the quick brown fox jumps over the lazy dog in line 1741
 * 1742: the quick brown fox jumps over the lazy dog in line 1742
 * 1743: the quick brown fox jumps over the lazy dog in line 1743
 * 1744: the quick brown fox jumps over the lazy dog in line 1744
 * 1745: the quick brown fox jumps over the lazy dog in line 1745
 * 1746: the quick brown fox jumps over the lazy dog in line 1746
 * 1747: the quick brown fox jumps over the lazy dog in line 1747
 * 1748: the quick brown fox jumps over the lazy dog in line 1748
 * 1749: the quick brown fox jumps over the lazy dog in line 1749
 * 1750: the quick brown fox jumps over the lazy dog in line 1750
 * 1751: the quick brown fox jumps over the lazy dog in line 1751
 * 1752: the quick brown fox jumps over the lazy dog in line 1752
 * 1753: the quick brown fox jumps over the lazy dog in line 1753
 * 1754: the quick brown fox jumps over the lazy dog in line 1754
 * 1755: the quick brown fox jumps over the lazy dog in line 1755
 * 1756: the quick brown fox jumps over the lazy dog in line 1756
 * 1757: the quick brown fox jumps over the lazy dog in line 1757
 * 1758: the quick brown fox jumps over the lazy dog in line 1758
 * 1759: the quick brown fox jumps over the lazy dog in line 1759
 * 1760: the quick brown fox jumps over the lazy dog in line 1760
 * 1761: the quick brown fox jumps over the lazy dog in line 1761
 * 1762: the quick brown fox jumps over the lazy dog in line 1762
 * 1763: the quick brown fox jumps over the lazy dog in line 1763
 * 1764: the quick brown fox jumps over the lazy dog in line 1764
 * 1765: the quick brown fox jumps over the lazy dog in line 1765
 * 1766: the quick brown fox jumps over the lazy dog in line 1766
 * 1767: the quick brown fox jumps over the lazy dog in line 1767
 * 1768: the quick brown fox jumps over the lazy dog in line 1768
 * 1769: the quick brown fox jumps over the lazy dog in line 1769
 * 1770: the quick brown fox jumps over the lazy dog in line 1770
 * 1771: the quick brown fox jumps over the lazy dog in line 1771
 * 1772: the quick brown fox jumps over the lazy dog in line 1772
 * 1773: the quick brown fox jumps over the lazy dog in line 1773
 * 1774: the quick brown fox jumps over the lazy dog in line 1774
 * 1775: the quick brown fox jumps over the lazy dog in line 1775
 * 1776: the quick brown fox jumps over the lazy dog in line 1776
 * 1777: the quick brown fox jumps over the lazy dog in line 1777
 * 1778: the quick brown fox jumps over the lazy dog in line 1778
 * 1779: the quick brown fox jumps over the lazy dog in line 1779
 * 1780: the quick brown fox jumps over the lazy dog in line 1780
 * 1781: the quick brown fox jumps over the lazy dog in line 1781
 * 1782: the quick brown fox jumps over the lazy dog in line 1782
 * 1783: the quick brown fox jumps over the lazy dog in line 1783
 * 1784: the quick brown fox jumps over the lazy dog in line 1784
 * 1785: the quick brown fox jumps over the lazy dog in line 1785
 * 1786: the quick brown fox jumps over the lazy dog in line 1786
 * 1787: the quick brown fox jumps over the lazy dog in line 1787
 * 1788: the quick brown fox jumps over the lazy dog in line 1788
 * 1789: the quick brown fox jumps over the lazy dog in line 1789
 * 1790: the quick brown fox jumps over the lazy dog in line 1790
 * 1791: the quick brown fox jumps over the lazy dog in line 1791
 * 1792: the quick brown fox jumps over the lazy dog in line 1792
 * 1793: the quick brown fox jumps over the lazy dog in line 1793
 * 1794: the quick brown fox jumps over the lazy dog in line 1794
 * 1795: the quick brown fox jumps over the lazy dog in line 1795
 * 1796: the quick brown fox jumps over the lazy dog in line 1796
 * 1797: the quick brown fox jumps over the lazy dog in line 1797
 * 1798: the quick brown fox jumps over the lazy dog in line 1798
 * 1799: the quick brown fox jumps over the lazy dog in line 1799
 * 1800: the quick brown fox jumps over the lazy dog in line 1800
 * 1801: the quick brown fox jumps over the lazy dog in line 1801
 * 1802: the quick brown fox jumps over the lazy dog in line 1802
 * 1803: the quick brown fox jumps over the lazy dog in line 1803
 * 1804: the quick brown fox jumps over the lazy dog in line 1804
 * 1805: the quick brown fox jumps over the lazy dog in line 1805
 * 1806: the quick brown fox jumps over the lazy dog in line 1806
 * 1807: the quick brown fox jumps over the lazy dog in line 1807
 * 1808: the quick brown fox jumps over the lazy dog in line 1808
 * 1809: the quick brown fox jumps over the lazy dog in line 1809
 * 1810: the quick brown fox jumps over the lazy dog in line 1810
 * 1811: the quick brown fox jumps over the lazy dog in line 1811
 * 1812: the quick brown fox jumps over the lazy dog in line 1812
 * 1813: the quick brown fox jumps over the lazy dog in line 1813
 * 1814: the quick brown fox jumps over the lazy dog in line 1814
 * 1815: the quick brown fox jumps over the lazy dog in line 1815
 * 1816: the quick brown fox jumps over the lazy dog in line 1816
 * 1817: the quick brown fox jumps over the lazy dog in line 1817
 * 1818: the quick brown fox jumps over the lazy dog in line 1818
 * 1819: the quick brown fox jumps over the lazy dog in line 1819
 * 1820: the quick brown fox jumps over the lazy dog in line 1820
 * 1821: the quick brown fox jumps over the lazy dog in line 1821
 * 1822: the quick brown fox jumps over the lazy dog in line 1822
 * 1823: the quick brown fox jumps over the lazy dog in line 1823
 * 1824: the quick brown fox jumps over the lazy dog in line 1824
 * 1825: the quick brown fox jumps over the lazy dog in line 1825
 * 1826: the quick brown fox jumps over the lazy dog in line 1826
 * 1827: the quick brown fox jumps over the lazy dog in line 1827
 * 1828: the quick brown fox jumps over the lazy dog in line 1828
 * 1829: the quick brown fox jumps over the lazy dog in line 1829
 * 1830: the quick brown fox jumps over the lazy dog in line 1830
 * 1831: the quick brown fox jumps over the lazy dog in line 1831
 * 1832: the quick brown fox jumps over the lazy dog in line 1832
 * 1833: the quick brown fox jumps over the lazy dog in line 1833
 * 1834: the quick brown fox jumps over the lazy dog in line 1834
 * 1835: the quick brown fox jumps over the lazy dog in line 1835
 * 1836: the quick brown fox jumps over the lazy dog in line 1836
 * 1837: the quick brown fox jumps over the lazy dog in line 1837
 * 1838: the quick brown fox jumps over the lazy dog in line 1838
 * 1839: the quick brown fox jumps over the lazy dog in line 1839
 * 1840: the quick brown fox jumps over the lazy dog in line 1840
 * 1841: the quick brown fox jumps over the lazy dog in line 1841
 * 1842: the quick brown fox jumps over the lazy dog in line 1842
 * 1843: the quick brown fox jumps over the lazy dog in line 1843
 * 1844: the quick brown fox jumps over the lazy dog in line 1844
 * 1845: the quick brown fox jumps over the lazy dog in line 1845
 * 1846: the quick brown fox jumps over the lazy dog in line 1846
 * 1847: the quick brown fox jumps over the lazy dog in line 1847
 * 1848: the quick brown fox jumps over the lazy dog in line 1848
 * 1849: the quick brown fox jumps over the lazy dog in line 1849
 * 1850: the quick brown fox jumps over the lazy dog in line 1850
 * 1851: the quick brown fox jumps over the lazy dog in line 1851
 * 1852: the quick brown fox jumps over the lazy dog in line 1852
 * 1853: the quick brown fox jumps over the lazy dog in line 1853
 * 1854: the quick brown fox jumps over the lazy dog in line 1854
 * 1855: the quick brown fox jumps over the lazy dog in line 1855
 * 1856: the quick brown fox jumps over the lazy dog in line 1856
 * 1857: the quick brown fox jumps over the lazy dog in line 1857
 * 1858: the quick brown fox jumps over the lazy dog in line 1858
 * 1859: the quick brown fox jumps over the lazy dog in line 1859
 * 1860: the quick brown fox jumps over the lazy dog in line 1860
 * 1861: the quick brown fox jumps over the lazy dog in line 1861
 * 1862: the quick brown fox jumps over the lazy dog in line 1862
 * 1863: the quick brown fox jumps over the lazy dog in line 1863
 * 1864: the quick brown fox jumps over the lazy dog in line 1864
 * 1865: the quick brown fox jumps over the lazy dog in line 1865
 * 1866: the quick brown fox jumps over the lazy dog in line 1866
 * 1867: the quick brown fox jumps over the lazy dog in line 1867
 * 1868: the quick brown fox jumps over the lazy dog in line 1868
 * 1869: the quick brown fox jumps over the lazy dog in line 1869
 * 1870: the quick brown fox jumps over the lazy dog in line 1870
 * 1871: the quick brown fox jumps over the lazy dog in line 1871
 * 1872: the quick brown fox jumps over the lazy dog in line 1872
 * 1873: the quick brown fox jumps over the lazy dog in line 1873
 * 1874: the quick brown fox jumps over the lazy dog in line 1874
 * 1875: the quick brown fox jumps over the lazy dog in line 1875
 * 1876: the quick brown fox jumps over the lazy dog in line 1876
 * 1877: the quick brown fox jumps over the lazy dog in line 1877
 * 1878: the quick brown fox jumps over the lazy dog in line 1878
 * 1879: the quick brown fox jumps over the lazy dog in line 1879
 * 1880: the quick brown fox jumps over the lazy dog in line 1880
 * 1881: the quick brown fox jumps over the lazy dog in line 1881
 * 1882: the quick brown fox jumps over the lazy dog in line 1882
 * 1883: the quick brown fox jumps over the lazy dog in line 1883
 * 1884: the quick brown fox jumps over the lazy dog in line 1884
 * 1885: the quick brown fox jumps over the lazy dog in line 1885
 * 1886: the quick brown fox jumps over the lazy dog in line 1886
 * 1887: the quick brown fox jumps over the lazy dog in line 1887
 * 1888: the quick brown fox jumps over the lazy dog in line 1888
 * 1889: the quick brown fox jumps over the lazy dog in line 1889
 * 1890: the quick brown fox jumps over the lazy dog in line 1890
 * 1891: the quick brown fox jumps over the lazy dog in line 1891
 * 1892: the quick brown fox jumps over the lazy dog in line 1892
 * 1893: the quick brown fox jumps over the lazy dog in line 1893
 * 1894: the quick brown fox jumps over the lazy dog in line 1894
 * 1895: the quick brown fox jumps over the lazy dog in line 1895
 * 1896: the quick brown fox jumps over the lazy dog in line 1896
 * 1897: the quick brown fox jumps over the lazy dog in line 1897
 * 1898: the quick brown fox jumps over the lazy dog in line 1898
 * 1899: the quick brown fox jumps over the lazy dog in line 1899
 * 1900: the quick brown fox jumps over the lazy dog in line 1900
 * 1901: the quick brown fox jumps over the lazy dog in line 1901
 * 1902: the quick brown fox jumps over the lazy dog in line 1902
 * 1903: the quick brown fox jumps over the lazy dog in line 1903
 * 1904: the quick brown fox jumps over the lazy dog in line 1904
 * 1905: the quick brown fox jumps over the lazy dog in line 1905
 * 1906: the quick brown fox jumps over the lazy dog in line 1906
 * 1907: the quick brown fox jumps over the lazy dog in line 1907
 * 1908: the quick brown fox jumps over the lazy dog in line 1908
 * 1909: the quick brown fox jumps over the lazy dog in line 1909
 * 1910: the quick brown fox jumps over the lazy dog in line 1910
 * 1911: the quick brown fox jumps over the lazy dog in line 1911
 * 1912: the quick brown fox jumps over the lazy dog in line 1912
 * 1913: the quick brown fox jumps over the lazy dog in line 1913
 * 1914: the quick brown fox jumps over the lazy dog in line 1914
 * 1915: the quick brown fox jumps over the lazy dog in line 1915
 * 1916: the quick brown fox jumps over the lazy dog in line 1916
 * 1917: the quick brown fox jumps over the lazy dog in line 1917
 * 1918: the quick brown fox jumps over the lazy dog in line 1918
 * 1919: the quick brown fox jumps over the lazy dog in line 1919
 * 1920: the quick brown fox jumps over the lazy dog in line 1920
 * 1921: the quick brown fox jumps over the lazy dog in line 1921
 * 1922: the quick brown fox jumps over the lazy dog in line 1922
 * 1923: the quick brown fox jumps over the lazy dog in line 1923
 * 1924: the quick brown fox jumps over the lazy dog in line 1924
 * 1925: the quick brown fox jumps over the lazy dog in line 1925
 * 1926: the quick brown fox jumps over the lazy dog in line 1926
 * 1927: the quick brown fox jumps over the lazy dog in line 1927
 * 1928: the quick brown fox jumps over the lazy dog in line 1928
 * 1929: the quick brown fox jumps over the lazy dog in line 1929
 * 1930: the quick brown fox jumps over the lazy dog in line 1930
 * 1931: the quick brown fox jumps over the lazy dog in line 1931
 * 1932: the quick brown fox jumps over the lazy dog in line 1932
 * 1933: the quick brown fox jumps over the lazy dog in line 1933
 * 1934: the quick brown fox jumps over the lazy dog in line 1934
 * 1935: the quick brown fox jumps over the lazy dog in line 1935
 * 1936: the quick brown fox jumps over the lazy dog in line 1936
 * 1937: the quick brown fox jumps over the lazy dog in line 1937
 * 1938: the quick brown fox jumps over the lazy dog in line 1938
 * 1939: the quick brown fox jumps over the lazy dog in line 1939
 * 1940: the quick brown fox jumps over the lazy dog in line 1940
 * 1941: the quick brown fox jumps over the lazy dog in line 1941
 * 1942: the quick brown fox jumps over the lazy dog in line 1942
 * 1943: the quick brown fox jumps over the lazy dog in line 1943
 * 1944: the quick brown fox jumps over the lazy dog in line 1944
 * 1945: the quick brown fox jumps over the lazy dog in line 1945
 * 1946: the quick brown fox jumps over the lazy dog in line 1946
 * 1947: the quick brown fox jumps over the lazy dog in line 1947
 * 1948: the quick brown fox jumps over the lazy dog in line 1948
 * 1949: the quick brown fox jumps over the lazy dog in line 1949
 * 1950: the quick brown fox jumps over the lazy dog in line 1950
 * 1951: the quick brown fox jumps over the lazy dog in line 1951
 * 1952: the quick brown fox jumps over the lazy dog in line 1952
 * 1953: the quick brown fox jumps over the lazy dog in line 1953
 * 1954: the quick brown fox jumps over the lazy dog in line 1954
 * 1955: the quick brown fox jumps over the lazy dog in line 1955
 * 1956: the quick brown fox jumps over the lazy dog in line 1956
 * 1957: the quick brown fox jumps over the lazy dog in line 1957
 * 1958: the quick brown fox jumps over the lazy dog in line 1958
 * 1959: the quick brown fox jumps over the lazy dog in line 1959
 * 1960: the quick brown fox jumps over the lazy dog in line 1960
 * 1961: the quick brown fox jumps over the lazy dog in line 1961
 * 1962: the quick brown fox jumps over the lazy dog in line 1962
 * 1963: the quick brown fox jumps over the lazy dog in line 1963
 * 1964: the quick brown fox jumps over the lazy dog in line 1964
 * 1965: the quick brown fox jumps over the lazy dog in line 1965
 * 1966: the quick brown fox jumps over the lazy dog in line 1966
 * 1967: the quick brown fox jumps over the lazy dog in line 1967
 * 1968: the quick brown fox jumps over the lazy dog in line 1968
 * 1969: the quick brown fox jumps over the lazy dog in line 1969
 * 1970: the quick brown fox jumps over the lazy dog in line 1970
 * 1971: the quick brown fox jumps over the lazy dog in line 1971
 * 1972: the quick brown fox jumps over the lazy dog in line 1972
 * 1973: the quick brown fox jumps over the lazy dog in line 1973
 * 1974: the quick brown fox jumps over the lazy dog in line 1974
 * 1975: the quick brown fox jumps over the lazy dog in line 1975
 * 1976: the quick brown fox jumps over the lazy dog in line 1976
 * 1977: the quick brown fox jumps over the lazy dog in line 1977
 * 1978: the quick brown fox jumps over the lazy dog in line 1978
 * 1979: the quick brown fox jumps over the lazy dog in line 1979
 * 1980: the quick brown fox jumps over the lazy dog in line 1980
 * 1981: the quick brown fox jumps over the lazy dog in line 1981
 * 1982: the quick brown fox jumps over the lazy dog in line 1982
 * 1983: the quick brown fox jumps over the lazy dog in line 1983
 * 1984: the quick brown fox jumps over the lazy dog in line 1984
 * 1985: the quick brown fox jumps over the lazy dog in line 1985
 * 1986: the quick brown fox jumps over the lazy dog in line 1986
 * 1987: the quick brown fox jumps over the lazy dog in line 1987
 * 1988: the quick brown fox jumps over the lazy dog in line 1988
 * 1989: the quick brown fox jumps over the lazy dog in line 1989
 * 1990: the quick brown fox jumps over the lazy dog in line 1990
 * 1991: the quick brown fox jumps over the lazy dog in line 1991
 * 1992: the quick brown fox jumps over the lazy dog in line 1992
 * 1993: the quick brown fox jumps over the lazy dog in line 1993
 * 1994: the quick brown fox jumps over the lazy dog in line 1994
 * 1995: the quick brown fox jumps over the lazy dog in line 1995
 * 1996: the quick brown fox jumps over the lazy dog in line 1996
 * 1997: the quick brown fox jumps over the lazy dog in line 1997
 * 1998: the quick brown fox jumps over the lazy dog in line 1998
 * 1999: the quick brown fox jumps over the lazy dog in line 1999
 * 2000: the quick brown fox jumps over the lazy dog in line 2000
 * 2001: the quick brown fox jumps over the lazy dog in line 2001
 * 2002: the quick brown fox jumps over the lazy dog in line 2002
 * 2003: the quick brown fox jumps over the lazy dog in line 2003
 * 2004: the quick brown fox jumps over the lazy dog in line 2004
 * 2005: the quick brown fox jumps over the lazy dog in line 2005
 * 2006: the quick brown fox jumps over the lazy dog in line 2006
 * 2007: the quick brown fox jumps over the lazy dog in line 2007
 * 2008: the quick brown fox jumps over the lazy dog in line 2008
 * 2009: the quick brown fox jumps over the lazy dog in line 2009
 * 2010: the quick brown fox jumps over the lazy dog in line 2010
 * 2011: the quick brown fox jumps over the lazy dog in line 2011
 * 2012: the quick brown fox jumps over the lazy dog in line 2012
 * 2013: the quick brown fox jumps over the lazy dog in line 2013
 * 2014: the quick brown fox jumps over the lazy dog in line 2014
 * 2015: the quick brown fox jumps over the lazy dog in line 2015
 * 2016: the quick brown fox jumps over the lazy dog in line 2016
 * 2017: the quick brown fox jumps over the lazy dog in line 2017
 * 2018: the quick brown fox jumps over the lazy dog in line 2018
 * 2019: the quick brown fox jumps over the lazy dog in line 2019
 * 2020: the quick brown fox jumps over the lazy dog in line 2020
 * 2021: the quick brown fox jumps over the lazy dog in line 2021
 * 2022: the quick brown fox jumps over the lazy dog in line 2022
 * 2023: the quick brown fox jumps over the lazy dog in line 2023
 * 2024: the quick brown fox jumps over the lazy dog in line 2024
 * 2025: the quick brown fox jumps over the lazy dog in line 2025
 * 2026: the quick brown fox jumps over the lazy dog in line 2026
 * 2027: the quick brown fox jumps over the lazy dog in line 2027
 * 2028: the quick brown fox jumps over the lazy dog in line 2028
 * 2029: the quick brown fox jumps over the lazy dog in line 2029
 * 2030: the quick brown fox jumps over the lazy dog in line 2030
 * 2031: the quick brown fox jumps over the lazy dog in line 2031
 * 2032: the quick brown fox jumps over the lazy dog in line 2032
 * 2033: the quick brown fox jumps over the lazy dog in line 2033
 * 2034: the quick brown fox jumps over the lazy dog in line 2034
 * 2035: the quick brown fox jumps over the lazy dog in line 2035
 * 2036: the quick brown fox jumps over the lazy dog in line 2036
 * 2037: the quick brown fox jumps over the lazy dog in line 2037
 * 2038: the quick brown fox jumps over the lazy dog in line 2038
 * 2039: the quick brown fox jumps over the lazy dog in line 2039
 * 2040: the quick brown fox jumps over the lazy dog in line 2040
 * 2041: the quick brown fox jumps over the lazy dog in line 2041
 * 2042: the quick brown fox jumps over the lazy dog in line 2042
 * 2043: the quick brown fox jumps over the lazy dog in line 2043
 * 2044: the quick brown fox jumps over the lazy dog in line 2044
 * 2045: the quick brown fox jumps over the lazy dog in line 2045
 * 2046: the quick brown fox jumps over the lazy dog in line 2046
 * 2047: the quick brown fox jumps over the lazy dog in line 2047
 * 2048: the quick brown fox jumps over the lazy dog in line 2048
 * 2049: the quick brown fox jumps over the lazy dog in line 2049
 * 2050: the quick brown fox jumps over the lazy dog in line 2050
 * 2051: the quick brown fox jumps over the lazy dog in line 2051
 * 2052: the quick brown fox jumps over the lazy dog in line 2052
 * 2053: the quick brown fox jumps over the lazy dog in line 2053
 * 2054: the quick brown fox jumps over the lazy dog in line 2054
 * 2055: the quick brown fox jumps over the lazy dog in line 2055
 * 2056: the quick brown fox jumps over the lazy dog in line 2056
 * 2057: the quick brown fox jumps over the lazy dog in line 2057
 * 2058: the quick brown fox jumps over the lazy dog in line 2058
 * 2059: the quick brown fox jumps over the lazy dog in line 2059
 * 2060: the quick brown fox jumps over the lazy dog in line 2060
 * 2061: the quick brown fox jumps over the lazy dog in line 2061
 * 2062: the quick brown fox jumps over the lazy dog in line 2062
 * 2063: the quick brown fox jumps over the lazy dog in line 2063
 * 2064: the quick brown fox jumps over the lazy dog in line 2064
 * 2065: the quick brown fox jumps over the lazy dog in line 2065
 * 2066: the quick brown fox jumps over the lazy dog in line 2066
 * 2067: the quick brown fox jumps over the lazy dog in line 2067
 * 2068: the quick brown fox jumps over the lazy dog in line 2068
 * 2069: the quick brown fox jumps over the lazy dog in line 2069
 * 2070: the quick brown fox jumps over the lazy dog in line 2070
 * 2071: the quick brown fox jumps over the lazy dog in line 2071
 * 2072: the quick brown fox jumps over the lazy dog in line 2072
 * 2073: the quick brown fox jumps over the lazy dog in line 2073
 * 2074: the quick brown fox jumps over the lazy dog in line 2074
 * 2075: the quick brown fox jumps over the lazy dog in line 2075
 * 2076: the quick brown fox jumps over the lazy dog in line 2076
 * 2077: the quick brown fox jumps over the lazy dog in line 2077
 * 2078: the quick brown fox jumps over the lazy dog in line 2078
 * 2079: the quick brown fox jumps over the lazy dog in line 2079
 * 2080: the quick brown fox jumps over the lazy dog in line 2080
 * 2081: the quick brown fox jumps over the lazy dog in line 2081
 * 2082: the quick brown fox jumps over the lazy dog in line 2082
 * 2083: the quick brown fox jumps over the lazy dog in line 2083
 * 2084: the quick brown fox jumps over the lazy dog in line 2084
 * 2085: the quick brown fox jumps over the lazy dog in line 2085
 * 2086: the quick brown fox jumps over the lazy dog in line 2086
 * 2087: the quick brown fox jumps over the lazy dog in line 2087
 * 2088: the quick brown fox jumps over the lazy dog in line 2088
 * 2089: the quick brown fox jumps over the lazy dog in line 2089
 * 2090: the quick brown fox jumps over the lazy dog in line 2090
 * 2091: the quick brown fox jumps over the lazy dog in line 2091
 * 2092: the quick brown fox jumps over the lazy dog in line 2092
 * 2093: the quick brown fox jumps over the lazy dog in line 2093
 * 2094: the quick brown fox jumps over the lazy dog in line 2094
 * 2095: the quick brown fox jumps over the lazy dog in line 2095
 * 2096: the quick brown fox jumps over the lazy dog in line 2096
 * 2097: the quick brown fox jumps over the lazy dog in line 2097
 * 2098: the quick brown fox jumps over the lazy dog in line 2098
 * 2099: the quick brown fox jumps over the lazy dog in line 2099
 * 2100: the quick brown fox jumps over the lazy dog in line 2100
 * 2101: the quick brown fox jumps over the lazy dog in line 2101
 * 2102: the quick brown fox jumps over the lazy dog in line 2102
 * 2103: the quick brown fox jumps over the lazy dog in line 2103
 * 2104: the quick brown fox jumps over the lazy dog in line 2104
 * 2105: the quick brown fox jumps over the lazy dog in line 2105
 * 2106: the quick brown fox jumps over the lazy dog in line 2106
 * 2107: the quick brown fox jumps over the lazy dog in line 2107
 * 2108: the quick brown fox jumps over the lazy dog in line 2108
 * 2109: the quick brown fox jumps over the lazy dog in line 2109
 * 2110: the quick brown fox jumps over the lazy dog in line 2110
 * 2111: the quick brown fox jumps over the lazy dog in line 2111
 * 2112: the quick brown fox jumps over the lazy dog in line 2112
 * 2113: the quick brown fox jumps over the lazy dog in line 2113
 * 2114: the quick brown fox jumps over the lazy dog in line 2114
 * 2115: the quick brown fox jumps over the lazy dog in line 2115
 * 2116: the quick brown fox jumps over the lazy dog in line 2116
 * 2117: the quick brown fox jumps over the lazy dog in line 2117
 * 2118: the quick brown fox jumps over the lazy dog in line 2118
 * 2119: the quick brown fox jumps over the lazy dog in line 2119
 * 2120: the quick brown fox jumps over the lazy dog in line 2120
 * 2121: the quick brown fox jumps over the lazy dog in line 2121
 * 2122: the quick brown fox jumps over the lazy dog in line 2122
 * 2123: the quick brown fox jumps over the lazy dog in line 2123
 * 2124: the quick brown fox jumps over the lazy dog in line 2124
 * 2125: the quick brown fox jumps over the lazy dog in line 2125
 * 2126: the quick brown fox jumps over the lazy dog in line 2126
 * 2127: the quick brown fox jumps over the lazy dog in line 2127
 * 2128: the quick brown fox jumps over the lazy dog in line 2128
 * 2129: the quick brown fox jumps over the lazy dog in line 2129
 * 2130: the quick brown fox jumps over the lazy dog in line 2130
 * 2131: the quick brown fox jumps over the lazy dog in line 2131
 * 2132: the quick brown fox jumps over the lazy dog in line 2132
 * 2133: the quick brown fox jumps over the lazy dog in line 2133
 * 2134: the quick brown fox jumps over the lazy dog in line 2134
 * 2135: the quick brown fox jumps over the lazy dog in line 2135
 * 2136: the quick brown fox jumps over the lazy dog in line 2136
 * 2137: the quick brown fox jumps over the lazy dog in line 2137
 * 2138: the quick brown fox jumps over the lazy dog in line 2138
 * 2139: the quick brown fox jumps over the lazy dog in line 2139
 * 2140: the quick brown fox jumps over the lazy dog in line 2140
 * 2141: the quick brown fox jumps over the lazy dog in line 2141
 * 2142: the quick brown fox jumps over the lazy dog in line 2142
 * 2143: the quick brown fox jumps over the lazy dog in line 2143
 * 2144: the quick brown fox jumps over the lazy dog in line 2144
 * 2145: the quick brown fox jumps over the lazy dog in line 2145
 * 2146: the quick brown fox jumps over the lazy dog in line 2146
 * 2147: the quick brown fox jumps over the lazy dog in line 2147
 * 2148: the quick brown fox jumps over the lazy dog in line 2148
 * 2149: the quick brown fox jumps over the lazy dog in line 2149
 * 2150: the quick brown fox jumps over the lazy dog in line 2150
 * 2151: the quick brown fox jumps over the lazy dog in line 2151
 * 2152: the quick brown fox jumps over the lazy dog in line 2152
 * 2153: the quick brown fox jumps over the lazy dog in line 2153
 * 2154: the quick brown fox jumps over the lazy dog in line 2154
 * 2155: the quick brown fox jumps over the lazy dog in line 2155
 * 2156: the quick brown fox jumps over the lazy dog in line 2156
 * 2157: the quick brown fox jumps over the lazy dog in line 2157
 * 2158: the quick brown fox jumps over the lazy dog in line 2158
 * 2159: the quick brown fox jumps over the lazy dog in line 2159
 * 2160: the quick brown fox jumps over the lazy dog in line 2160
 * 2161: the quick brown fox jumps over the lazy dog in line 2161
 * 2162: the quick brown fox jumps over the lazy dog in line 2162
 * 2163: the quick brown fox jumps over the lazy dog in line 2163
 * 2164: the quick brown fox jumps over the lazy dog in line 2164
 * 2165: the quick brown fox jumps over the lazy dog in line 2165
 * 2166: the quick brown fox jumps over the lazy dog in line 2166
 * 2167: the quick brown fox jumps over the lazy dog in line 2167
 * 2168: the quick brown fox jumps over the lazy dog in line 2168
 * 2169: the quick brown fox jumps over the lazy dog in line 2169
 * 2170: the quick brown fox jumps over the lazy dog in line 2170
 * 2171: the quick brown fox jumps over the lazy dog in line 2171
 * 2172: the quick brown fox jumps over the lazy dog in line 2172
 * 2173: the quick brown fox jumps over the lazy dog in line 2173
 * 2174: the quick brown fox jumps over the lazy dog in line 2174
 * 2175: the quick brown fox jumps over the lazy dog in line 2175
 * 2176: the quick brown fox jumps over the lazy dog in line 2176
 * 2177: the quick brown fox jumps over the lazy dog in line 2177
 * 2178: the quick brown fox jumps over the lazy dog in line 2178
 * 2179: the quick brown fox jumps over the lazy dog in line 2179
 * 2180: the quick brown fox jumps over the lazy dog in line 2180
 * 2181: the quick brown fox jumps over the lazy dog in line 2181
 * 2182: the quick brown fox jumps over the lazy dog in line 2182
 * 2183: the quick brown fox jumps over the lazy dog in line 2183
 * 2184: the quick brown fox jumps over the lazy dog in line 2184
 * 2185: the quick brown fox jumps over the lazy dog in line 2185
 * 2186: the quick brown fox jumps over the lazy dog in line 2186
 * 2187: the quick brown fox jumps over the lazy dog in line 2187
 * 2188: the quick brown fox jumps over the lazy dog in line 2188
 * 2189: the quick brown fox jumps over the lazy dog in line 2189
 * 2190: the quick brown fox jumps over the lazy dog in line 2190
 * 2191: the quick brown fox jumps over the lazy dog in line 2191
 * 2192: the quick brown fox jumps over the lazy dog in line 2192
 * 2193: the quick brown fox jumps over the lazy dog in line 2193
 * 2194: the quick brown fox jumps over the lazy dog in line 2194
 * 2195: the quick brown fox jumps over the lazy dog in line 2195
 * 2196: the quick brown fox jumps over the lazy dog in line 2196
 * 2197: the quick brown fox jumps over the lazy dog in line 2197
 * 2198: the quick brown fox jumps over the lazy dog in line 2198
 * 2199: the quick brown fox jumps over the lazy dog in line 2199
 * 2200: the quick brown fox jumps over the lazy dog in line 2200
 * 2201: the quick brown fox jumps over the lazy dog in line 2201
 * 2202: the quick brown fox jumps over the lazy dog in line 2202
 * 2203: the quick brown fox jumps over the lazy dog in line 2203
 * 2204: the quick brown fox jumps over the lazy dog in line 2204
 * 2205: the quick brown fox jumps over the lazy dog in line 2205
 * 2206: the quick brown fox jumps over the lazy dog in line 2206
 * 2207: the quick brown fox jumps over the lazy dog in line 2207
 * 2208: the quick brown fox jumps over the lazy dog in line 2208
 * 2209: the quick brown fox jumps over the lazy dog in line 2209
 * 2210: the quick brown fox jumps over the lazy dog in line 2210
 * 2211: the quick brown fox jumps over the lazy dog in line 2211
 * 2212: the quick brown fox jumps over the lazy dog in line 2212
 * 2213: the quick brown fox jumps over the lazy dog in line 2213
 * 2214: the quick brown fox jumps over the lazy dog in line 2214
 * 2215: the quick brown fox jumps over the lazy dog in line 2215
 * 2216: the quick brown fox jumps over the lazy dog in line 2216
 * 2217: the quick brown fox jumps over the lazy dog in line 2217
 * 2218: the quick brown fox jumps over the lazy dog in line 2218
 * 2219: the quick brown fox jumps over the lazy dog in line 2219
 * 2220: the quick brown fox jumps over the lazy dog in line 2220
 * 2221: the quick brown fox jumps over the lazy dog in line 2221
 * 2222: the quick brown fox jumps over the lazy dog in line 2222
 * 2223: the quick brown fox jumps over the lazy dog in line 2223
 * 2224: the quick brown fox jumps over the lazy dog in line 2224
 * 2225: the quick brown fox jumps over the lazy dog in line 2225
 * 2226: the quick brown fox jumps over the lazy dog in line 2226
 * 2227: the quick brown fox jumps over the lazy dog in line 2227
 * 2228: the quick brown fox jumps over the lazy dog in line 2228
 * 2229: the quick brown fox jumps over the lazy dog in line 2229
 * 2230: the quick brown fox jumps over the lazy dog in line 2230
 * 2231: the quick brown fox jumps over the lazy dog in line 2231
 * 2232: the quick brown fox jumps over the lazy dog in line 2232
 * 2233: the quick brown fox jumps over the lazy dog in line 2233
 * 2234: the quick brown fox jumps over the lazy dog in line 2234
 * 2235: the quick brown fox jumps over the lazy dog in line 2235
 * 2236: the quick brown fox jumps over the lazy dog in line 2236
 * 2237: the quick brown fox jumps over the lazy dog in line 2237
 * 2238: the quick brown fox jumps over the lazy dog in line 2238
 * 2239: the quick brown fox jumps over the lazy dog in line 2239
 * 2240: the quick brown fox jumps over the lazy dog in line 2240
 * 2241: the quick brown fox jumps over the lazy dog in line 2241
 * 2242: the quick brown fox jumps over the lazy dog in line 2242
 * 2243: the quick brown fox jumps over the lazy dog in line 2243
 * 2244: the quick brown fox jumps over the lazy dog in line 2244
 * 2245: the quick brown fox jumps over the lazy dog in line 2245
 * 2246: the quick brown fox jumps over the lazy dog in line 2246
 * 2247: the quick brown fox jumps over the lazy dog in line 2247
 * 2248: the quick brown fox jumps over the lazy dog in line 2248
 * 2249: the quick brown fox jumps over the lazy dog in line 2249
 * 2250: the quick brown fox jumps over the lazy dog in line 2250
 * 2251: the quick brown fox jumps over the lazy dog in line 2251
 * 2252: the quick brown fox jumps over the lazy dog in line 2252
 * 2253: the quick brown fox jumps over the lazy dog in line 2253
 * 2254: the quick brown fox jumps over the lazy dog in line 2254
 * 2255: the quick brown fox jumps over the lazy dog in line 2255
 * 2256: the quick brown fox jumps over the lazy dog in line 2256
 * 2257: the quick brown fox jumps over the lazy dog in line 2257
 * 2258: the quick brown fox jumps over the lazy dog in line 2258
 * 2259: the quick brown fox jumps over the lazy dog in line 2259
 * 2260: the quick brown fox jumps over the lazy dog in line 2260
 * 2261: the quick brown fox jumps over the lazy dog in line 2261
 * 2262: the quick brown fox jumps over the lazy dog in line 2262
 * 2263: the quick brown fox jumps over the lazy dog in line 2263
 * 2264: the quick brown fox jumps over the lazy dog in line 2264
 * 2265: the quick brown fox jumps over the lazy dog in line 2265
 * 2266: the quick brown fox jumps over the lazy dog in line 2266
 * 2267: the quick brown fox jumps over the lazy dog in line 2267
 * 2268: the quick brown fox jumps over the lazy dog in line 2268
 * 2269: the quick brown fox jumps over the lazy dog in line 2269
 * 2270: the quick brown fox jumps over the lazy dog in line 2270
 * 2271: the quick brown fox jumps over the lazy dog in line 2271
 * 2272: the quick brown fox jumps over the lazy dog in line 2272
 * 2273: the quick brown fox jumps over the lazy dog in line 2273
 * 2274: the quick brown fox jumps over the lazy dog in line 2274
 * 2275: the quick brown fox jumps over the lazy dog in line 2275
 * 2276: the quick brown fox jumps over the lazy dog in line 2276
 * 2277: the quick brown fox jumps over the lazy dog in line 2277
 * 2278: the quick brown fox jumps over the lazy dog in line 2278
 * 2279: the quick brown fox jumps over the lazy dog in line 2279
 * 2280: the quick brown fox jumps over the lazy dog in line 2280
 * 2281: the quick brown fox jumps over the lazy dog in line 2281
 * 2282: the quick brown fox jumps over the lazy dog in line 2282
 * 2283: the quick brown fox jumps over the lazy dog in line 2283
 * 2284: the quick brown fox jumps over the lazy dog in line 2284
 * 2285: the quick brown fox jumps over the lazy dog in line 2285
 * 2286: the quick brown fox jumps over the lazy dog in line 2286
 * 2287: the quick brown fox jumps over the lazy dog in line 2287
 * 2288: the quick brown fox jumps over the lazy dog in line 2288
 * 2289: the quick brown fox jumps over the lazy dog in line 2289
 * 2290: the quick brown fox jumps over the lazy dog in line 2290
 * 2291: the quick brown fox jumps over the lazy dog in line 2291
 * 2292: the quick brown fox jumps over the lazy dog in line 2292
 * 2293: the quick brown fox jumps over the lazy dog in line 2293
 * 2294: the quick brown fox jumps over the lazy dog in line 2294
 * 2295: the quick brown fox jumps over the lazy dog in line 2295
 * 2296: the quick brown fox jumps over the lazy dog in line 2296
 * 2297: the quick brown fox jumps over the lazy dog in line 2297
 * 2298: the quick brown fox jumps over the lazy dog in line 2298
 * 2299: the quick brown fox jumps over the lazy dog in line 2299
 * 2300: the quick brown fox jumps over the lazy dog in line 2300
 * 2301: the quick brown fox jumps over the lazy dog in line 2301
 * 2302: the quick brown fox jumps over the lazy dog in line 2302
 * 2303: the quick brown fox jumps over the lazy dog in line 2303
 * 2304: the quick brown fox jumps over the lazy dog in line 2304
 * 2305: the quick brown fox jumps over the lazy dog in line 2305
 * 2306: the quick brown fox jumps over the lazy dog in line 2306
 * 2307: the quick brown fox jumps over the lazy dog in line 2307
 * 2308: the quick brown fox jumps over the lazy dog in line 2308
 * 2309: the quick brown fox jumps over the lazy dog in line 2309
 * 2310: the quick brown fox jumps over the lazy dog in line 2310
 * 2311: the quick brown fox jumps over the lazy dog in line 2311
 * 2312: the quick brown fox jumps over the lazy dog in line 2312
 * 2313: the quick brown fox jumps over the lazy dog in line 2313
 * 2314: the quick brown fox jumps over the lazy dog in line 2314
 * 2315: the quick brown fox jumps over the lazy dog in line 2315
 * 2316: the quick brown fox jumps over the lazy dog in line 2316
 * 2317: the quick brown fox jumps over the lazy dog in line 2317
 * 2318: the quick brown fox jumps over the lazy dog in line 2318
 * 2319: the quick brown fox jumps over the lazy dog in line 2319
 * 2320: the quick brown fox jumps over the lazy dog in line 2320
 * 2321: the quick brown fox jumps over the lazy dog in line 2321
 * 2322: the quick brown fox jumps over the lazy dog in line 2322
 * 2323: the quick brown fox jumps over the lazy dog in line 2323
 * 2324: the quick brown fox jumps over the lazy dog in line 2324
 * 2325: the quick brown fox jumps over the lazy dog in line 2325
 * 2326: the quick brown fox jumps over the lazy dog in line 2326
 * 2327: the quick brown fox jumps over the lazy dog in line 2327
 * 2328: the quick brown fox jumps over the lazy dog in line 2328
 * 2329: the quick brown fox jumps over the lazy dog in line 2329
 * 2330: the quick brown fox jumps over the lazy dog in line 2330
 * 2331: the quick brown fox jumps over the lazy dog in line 2331
 * 2332: the quick brown fox jumps over the lazy dog in line 2332
 * 2333: the quick brown fox jumps over the lazy dog in line 2333
 * 2334: the quick brown fox jumps over the lazy dog in line 2334
 * 2335: the quick brown fox jumps over the lazy dog in line 2335
 * 2336: the quick brown fox jumps over the lazy dog in line 2336
 * 2337: the quick brown fox jumps over the lazy dog in line 2337
 * 2338: the quick brown fox jumps over the lazy dog in line 2338
 * 2339: the quick brown fox jumps over the lazy dog in line 2339
 * 2340: the quick brown fox jumps over the lazy dog in line 2340
 * 2341: the quick brown fox jumps over the lazy dog in line 2341
 * 2342: the quick brown fox jumps over the lazy dog in line 2342
 * 2343: the quick brown fox jumps over the lazy dog in line 2343
 * 2344: the quick brown fox jumps over the lazy dog in line 2344
 * 2345: the quick brown fox jumps over the lazy dog in line 2345
 * 2346: the quick brown fox jumps over the lazy dog in line 2346
 * 2347: the quick brown fox jumps over the lazy dog in line 2347
 * 2348: the quick brown fox jumps over the lazy dog in line 2348
 * 2349: the quick brown fox jumps over the lazy dog in line 2349
 * 2350: the quick brown fox jumps over the lazy dog in line 2350
 * 2351: the quick brown fox jumps over the lazy dog in line 2351
 * 2352: the quick brown fox jumps over the lazy dog in line 2352
 * 2353: the quick brown fox jumps over the lazy dog in line 2353
 * 2354: the quick brown fox jumps over the lazy dog in line 2354
 * 2355: the quick brown fox jumps over the lazy dog in line 2355
 * 2356: the quick brown fox jumps over the lazy dog in line 2356
 * 2357: the quick brown fox jumps over the lazy dog in line 2357
 * 2358: the quick brown fox jumps over the lazy dog in line 2358
 * 2359: the quick brown fox jumps over the lazy dog in line 2359
 * 2360: the quick brown fox jumps over the lazy dog in line 2360
 * 2361: the quick brown fox jumps over the lazy dog in line 2361
 * 2362: the quick brown fox jumps over the lazy dog in line 2362
 * 2363: the quick brown fox jumps over the lazy dog in line 2363
 * 2364: the quick brown fox jumps over the lazy dog in line 2364
 * 2365: the quick brown fox jumps over the lazy dog in line 2365
 * 2366: the quick brown fox jumps over the lazy dog in line 2366
 * 2367: the quick brown fox jumps over the lazy dog in line 2367
 * 2368: the quick brown fox jumps over the lazy dog in line 2368
 * 2369: the quick brown fox jumps over the lazy dog in line 2369
 * 2370: the quick brown fox jumps over the lazy dog in line 2370
 * 2371: the quick brown fox jumps over the lazy dog in line 2371
 * 2372: the quick brown fox jumps over the lazy dog in line 2372
 * 2373: the quick brown fox jumps over the lazy dog in line 2373
 * 2374: the quick brown fox jumps over the lazy dog in line 2374
 * 2375: the quick brown fox jumps over the lazy dog in line 2375
 * 2376: the quick brown fox jumps over the lazy dog in line 2376
 * 2377: the quick brown fox jumps over the lazy dog in line 2377
 * 2378: the quick brown fox jumps over the lazy dog in line 2378
 * 2379: the quick brown fox jumps over the lazy dog in line 2379
 * 2380: the quick brown fox jumps over the lazy dog in line 2380
 * 2381: the quick brown fox jumps over the lazy dog in line 2381
 * 2382: the quick brown fox jumps over the lazy dog in line 2382
 * 2383: the quick brown fox jumps over the lazy dog in line 2383
 * 2384: the quick brown fox jumps over the lazy dog in line 2384
 * 2385: the quick brown fox jumps over the lazy dog in line 2385
 * 2386: the quick brown fox jumps over the lazy dog in line 2386
 * 2387: the quick brown fox jumps over the lazy dog in line 2387
 * 2388: the quick brown fox jumps over the lazy dog in line 2388
 * 2389: the quick brown fox jumps over the lazy dog in line 2389
 * 2390: the quick brown fox jumps over the lazy dog in line 2390
 * 2391: the quick brown fox jumps over the lazy dog in line 2391
 * 2392: the quick brown fox jumps over the lazy dog in line 2392
 * 2393: the quick brown fox jumps over the lazy dog in line 2393
 * 2394: the quick brown fox jumps over the lazy dog in line 2394
 * 2395: the quick brown fox jumps over the lazy dog in line 2395
 * 2396: the quick brown fox jumps over the lazy dog in line 2396
 * 2397: the quick brown fox jumps over the lazy dog in line 2397
 * 2398: the quick brown fox jumps over the lazy dog in line 2398
 * 2399: the quick brown fox jumps over the lazy dog in line 2399
 * 2400: the quick brown fox jumps over the lazy dog in line 2400
 * 2401: the quick brown fox jumps over the lazy dog in line 2401
 * 2402: the quick brown fox jumps over the lazy dog in line 2402
 * 2403: the quick brown fox jumps over the lazy dog in line 2403
 * 2404: the quick brown fox jumps over the lazy dog in line 2404
 * 2405: the quick brown fox jumps over the lazy dog in line 2405
 * 2406: the quick brown fox jumps over the lazy dog in line 2406
 * 2407: the quick brown fox jumps over the lazy dog in line 2407
 * 2408: the quick brown fox jumps over the lazy dog in line 2408
 * 2409: the quick brown fox jumps over the lazy dog in line 2409
 * 2410: the quick brown fox jumps over the lazy dog in line 2410
 * 2411: the quick brown fox jumps over the lazy dog in line 2411
 * 2412: the quick brown fox jumps over the lazy dog in line 2412
 * 2413: the quick brown fox jumps over the lazy dog in line 2413
 * 2414: the quick brown fox jumps over the lazy dog in line 2414
 * 2415: the quick brown fox jumps over the lazy dog in line 2415
 * 2416: the quick brown fox jumps over the lazy dog in line 2416
 * 2417: the quick brown fox jumps over the lazy dog in line 2417
 * 2418: the quick brown fox jumps over the lazy dog in line 2418
 * 2419: the quick brown fox jumps over the lazy dog in line 2419
 * 2420: the quick brown fox jumps over the lazy dog in line 2420
 * 2421: the quick brown fox jumps over the lazy dog in line 2421
 * 2422: the quick brown fox jumps over the lazy dog in line 2422
 * 2423: the quick brown fox jumps over the lazy dog in line 2423
 * 2424: the quick brown fox jumps over the lazy dog in line 2424
 * 2425: the quick brown fox jumps over the lazy dog in line 2425
 * 2426: the quick brown fox jumps over the lazy dog in line 2426
 * 2427: the quick brown fox jumps over the lazy dog in line 2427
 * 2428: the quick brown fox jumps over the lazy dog in line 2428
 * 2429: the quick brown fox jumps over the lazy dog in line 2429
 * 2430: the quick brown fox jumps over the lazy dog in line 2430
 * 2431: the quick brown fox jumps over the lazy dog in line 2431
 * 2432: the quick brown fox jumps over the lazy dog in line 2432
 * 2433: the quick brown fox jumps over the lazy dog in line 2433
 * 2434: the quick brown fox jumps over the lazy dog in line 2434
 * 2435: the quick brown fox jumps over the lazy dog in line 2435
 * 2436: the quick brown fox jumps over the lazy dog in line 2436
 * 2437: the quick brown fox jumps over the lazy dog in line 2437
 * 2438: the quick brown fox jumps over the lazy dog in line 2438
 * 2439: the quick brown fox jumps over the lazy dog in line 2439
 * 2440: the quick brown fox jumps over the lazy dog in line 2440
 * 2441: the quick brown fox jumps over the lazy dog in line 2441
 * 2442: the quick brown fox jumps over the lazy dog in line 2442
 * 2443: the quick brown fox jumps over the lazy dog in line 2443
 * 2444: the quick brown fox jumps over the lazy dog in line 2444
 * 2445: the quick brown fox jumps over the lazy dog in line 2445
 * 2446: the quick brown fox jumps over the lazy dog in line 2446
 * 2447: the quick brown fox jumps over the lazy dog in line 2447
 * 2448: the quick brown fox jumps over the lazy dog in line 2448
 * 2449: the quick brown fox jumps over the lazy dog in line 2449
 * 2450: the quick brown fox jumps over the lazy dog in line 2450
 * 2451: the quick brown fox jumps over the lazy dog in line 2451
 * 2452: the quick brown fox jumps over the lazy dog in line 2452
 * 2453: the quick brown fox jumps over the lazy dog in line 2453
 * 2454: the quick brown fox jumps over the lazy dog in line 2454
 * 2455: the quick brown fox jumps over the lazy dog in line 2455
 * 2456: the quick brown fox jumps over the lazy dog in line 2456
 * 2457: the quick brown fox jumps over the lazy dog in line 2457
 * 2458: the quick brown fox jumps over the lazy dog in line 2458
 * 2459: the quick brown fox jumps over the lazy dog in line 2459
 * 2460: the quick brown fox jumps over the lazy dog in line 2460
 * 2461: the quick brown fox jumps over the lazy dog in line 2461
 * 2462: the quick brown fox jumps over the lazy dog in line 2462
 * 2463: the quick brown fox jumps over the lazy dog in line 2463
 * 2464: the quick brown fox jumps over the lazy dog in line 2464
 * 2465: the quick brown fox jumps over the lazy dog in line 2465
 * 2466: the quick brown fox jumps over the lazy dog in line 2466
 * 2467: the quick brown fox jumps over the lazy dog in line 2467
 * 2468: the quick brown fox jumps over the lazy dog in line 2468
 * 2469: the quick brown fox jumps over the lazy dog in line 2469
 * 2470: the quick brown fox jumps over the lazy dog in line 2470
 * 2471: the quick brown fox jumps over the lazy dog in line 2471
 * 2472: the quick brown fox jumps over the lazy dog in line 2472
 * 2473: the quick brown fox jumps over the lazy dog in line 2473
 * 2474: the quick brown fox jumps over the lazy dog in line 2474
 * 2475: the quick brown fox jumps over the lazy dog in line 2475
 * 2476: the quick brown fox jumps over the lazy dog in line 2476
 * 2477: the quick brown fox jumps over the lazy dog in line 2477
 * 2478: the quick brown fox jumps over the lazy dog in line 2478
 * 2479: the quick brown fox jumps over the lazy dog in line 2479
 * 2480: the quick brown fox jumps over the lazy dog in line 2480
 * 2481: the quick brown fox jumps over the lazy dog in line 2481
 * 2482: the quick brown fox jumps over the lazy dog in line 2482
 * 2483: the quick brown fox jumps over the lazy dog in line 2483
 * 2484: the quick brown fox jumps over the lazy dog in line 2484
 * 2485: the quick brown fox jumps over the lazy dog in line 2485
 * 2486: the quick brown fox jumps over the lazy dog in line 2486
 * 2487: the quick brown fox jumps over the lazy dog in line 2487
 * 2488: the quick brown fox jumps over the lazy dog in line 2488
 * 2489: the quick brown fox jumps over the lazy dog in line 2489
 * 2490: the quick brown fox jumps over the lazy dog in line 2490
 * 2491: the quick brown fox jumps over the lazy dog in line 2491
 * 2492: the quick brown fox jumps over the lazy dog in line 2492
 * 2493: the quick brown fox jumps over the lazy dog in line 2493
 * 2494: the quick brown fox jumps over the lazy dog in line 2494
 * 2495: the quick brown fox jumps over the lazy dog in line 2495
 * 2496: the quick brown fox jumps over the lazy dog in line 2496
 * 2497: the quick brown fox jumps over the lazy dog in line 2497
 * 2498: the quick brown fox jumps over the lazy dog in line 2498
 * 2499: the quick brown fox jumps over the lazy dog in line 2499
 * 2500: the quick brown fox jumps over the lazy dog in line 2500
 * 2501: the quick brown fox jumps over the lazy dog in line 2501
 * 2502: the quick brown fox jumps over the lazy dog in line 2502
 * 2503: the quick brown fox jumps over the lazy dog in line 2503
 * 2504: the quick brown fox jumps over the lazy dog in line 2504
 * 2505: the quick brown fox jumps over the lazy dog in line 2505
 * 2506: the quick brown fox jumps over the lazy dog in line 2506
 * 2507: the quick brown fox jumps over the lazy dog in line 2507
 * 2508: the quick brown fox jumps over the lazy dog in line 2508
 * 2509: the quick brown fox jumps over the lazy dog in line 2509
 * 2510: the quick brown fox jumps over the lazy dog in line 2510
 * 2511: the quick brown fox jumps over the lazy dog in line 2511
 * 2512: the quick brown fox jumps over the lazy dog in line 2512
 * 2513: the quick brown fox jumps over the lazy dog in line 2513
 * 2514: the quick brown fox jumps over the lazy dog in line 2514
 * 2515: the quick brown fox jumps over the lazy dog in line 2515
 * 2516: the quick brown fox jumps over the lazy dog in line 2516
 * 2517: the quick brown fox jumps over the lazy dog in line 2517
 * 2518: the quick brown fox jumps over the lazy dog in line 2518
 * 2519: the quick brown fox jumps over the lazy dog in line 2519
 * 2520: the quick brown fox jumps over the lazy dog in line 2520
 * 2521: the quick brown fox jumps over the lazy dog in line 2521
 * 2522: the quick brown fox jumps over the lazy dog in line 2522
 * 2523: the quick brown fox jumps over the lazy dog in line 2523
 * 2524: the quick brown fox jumps over the lazy dog in line 2524
 * 2525: the quick brown fox jumps over the lazy dog in line 2525
 * 2526: the quick brown fox jumps over the lazy dog in line 2526
 * 2527: the quick brown fox jumps over the lazy dog in line 2527
 * 2528: the quick brown fox jumps over the lazy dog in line 2528
 * 2529: the quick brown fox jumps over the lazy dog in line 2529
 * 2530: the quick brown fox jumps over the lazy dog in line 2530
 * 2531: the quick brown fox jumps over the lazy dog in line 2531
 * 2532: the quick brown fox jumps over the lazy dog in line 2532
 * 2533: the quick brown fox jumps over the lazy dog in line 2533
 * 2534: the quick brown fox jumps over the lazy dog in line 2534
 * 2535: the quick brown fox jumps over the lazy dog in line 2535
 * 2536: the quick brown fox jumps over the lazy dog in line 2536
 * 2537: the quick brown fox jumps over the lazy dog in line 2537
 * 2538: the quick brown fox jumps over the lazy dog in line 2538
 * 2539: the quick brown fox jumps over the lazy dog in line 2539
 * 2540: the quick brown fox jumps over the lazy dog in line 2540
 * 2541: the quick brown fox jumps over the lazy dog in line 2541
 * 2542: the quick brown fox jumps over the lazy dog in line 2542
 * 2543: the quick brown fox jumps over the lazy dog in line 2543
 * 2544: the quick brown fox jumps over the lazy dog in line 2544
 * 2545: the quick brown fox jumps over the lazy dog in line 2545
 * 2546: the quick brown fox jumps over the lazy dog in line 2546
 * 2547: the quick brown fox jumps over the lazy dog in line 2547
 * 2548: the quick brown fox jumps over the lazy dog in line 2548
 * 2549: the quick brown fox jumps over the lazy dog in line 2549
 * 2550: the quick brown fox jumps over the lazy dog in line 2550
 * 2551: the quick brown fox jumps over the lazy dog in line 2551
 * 2552: the quick brown fox jumps over the lazy dog in line 2552
 * 2553: the quick brown fox jumps over the lazy dog in line 2553
 * 2554: the quick brown fox jumps over the lazy dog in line 2554
 * 2555: the quick brown fox jumps over the lazy dog in line 2555
 * 2556: the quick brown fox jumps over the lazy dog in line 2556
 * 2557: the quick brown fox jumps over the lazy dog in line 2557
 * 2558: the quick brown fox jumps over the lazy dog in line 2558
 * 2559: the quick brown fox jumps over the lazy dog in line 2559
 * 2560: the quick brown fox jumps over the lazy dog in line 2560
 * 2561: the quick brown fox jumps over the lazy dog in line 2561
 * 2562: the quick brown fox jumps over the lazy dog in line 2562
 * 2563: the quick brown fox jumps over the lazy dog in line 2563
 * 2564: the quick brown fox jumps over the lazy dog in line 2564
 * 2565: the quick brown fox jumps over the lazy dog in line 2565
 * 2566: the quick brown fox jumps over the lazy dog in line 2566
 * 2567: the quick brown fox jumps over the lazy dog in line 2567
 * 2568: the quick brown fox jumps over the lazy dog in line 2568
 * 2569: the quick brown fox jumps over the lazy dog in line 2569
 * 2570: the quick brown fox jumps over the lazy dog in line 2570
 * 2571: the quick brown fox jumps over the lazy dog in line 2571
 * 2572: the quick brown fox jumps over the lazy dog in line 2572
 * 2573: the quick brown fox jumps over the lazy dog in line 2573
 * 2574: the quick brown fox jumps over the lazy dog in line 2574
 * 2575: the quick brown fox jumps over the lazy dog in line 2575
 * 2576: the quick brown fox jumps over the lazy dog in line 2576
 * 2577: the quick brown fox jumps over the lazy dog in line 2577
 * 2578: the quick brown fox jumps over the lazy dog in line 2578
 * 2579: the quick brown fox jumps over the lazy dog in line 2579
 * 2580: the quick brown fox jumps over the lazy dog in line 2580
 * 2581: the quick brown fox jumps over the lazy dog in line 2581
 * 2582: the quick brown fox jumps over the lazy dog in line 2582
 * 2583: the quick brown fox jumps over the lazy dog in line 2583
 * 2584: the quick brown fox jumps over the lazy dog in line 2584
 * 2585: the quick brown fox jumps over the lazy dog in line 2585
 * 2586: the quick brown fox jumps over the lazy dog in line 2586
 * 2587: the quick brown fox jumps over the lazy dog in line 2587
 * 2588: the quick brown fox jumps over the lazy dog in line 2588
 * 2589: the quick brown fox jumps over the lazy dog in line 2589
 * 2590: the quick brown fox jumps over the lazy dog in line 2590
 * 2591: the quick brown fox jumps over the lazy dog in line 2591
 * 2592: the quick brown fox jumps over the lazy dog in line 2592
 * 2593: the quick brown fox jumps over the lazy dog in line 2593
 * 2594: the quick brown fox jumps over the lazy dog in line 2594
 * 2595: the quick brown fox jumps over the lazy dog in line 2595
 * 2596: the quick brown fox jumps over the lazy dog in line 2596
 * 2597: the quick brown fox jumps over the lazy dog in line 2597
 * 2598: the quick brown fox jumps over the lazy dog in line 2598
 * 2599: the quick brown fox jumps over the lazy dog in line 2599
 * 2600: the quick brown fox jumps over the lazy dog in line 2600
 * 2601: the quick brown fox jumps over the lazy dog in line 2601
 * 2602: the quick brown fox jumps over the lazy dog in line 2602
 * 2603: the quick brown fox jumps over the lazy dog in line 2603
 * 2604: the quick brown fox jumps over the lazy dog in line 2604
 * 2605: the quick brown fox jumps over the lazy dog in line 2605
 * 2606: the quick brown fox jumps over the lazy dog in line 2606
 * 2607: the quick brown fox jumps over the lazy dog in line 2607
 * 2608: the quick brown fox jumps over the lazy dog in line 2608
 * 2609: the quick brown fox jumps over the lazy dog in line 2609
 * 2610: the quick brown fox jumps over the lazy dog in line 2610
 * 2611: the quick brown fox jumps over the lazy dog in line 2611
 * 2612: the quick brown fox jumps over the lazy dog in line 2612
 * 2613: the quick brown fox jumps over the lazy dog in line 2613
 * 2614: the quick brown fox jumps over the lazy dog in line 2614
 * 2615: the quick brown fox jumps over the lazy dog in line 2615
 * 2616: the quick brown fox jumps over the lazy dog in line 2616
 * 2617: the quick brown fox jumps over the lazy dog in line 2617
 * 2618: the quick brown fox jumps over the lazy dog in line 2618
 * 2619: the quick brown fox jumps over the lazy dog in line 2619
 * 2620: the quick brown fox jumps over the lazy dog in line 2620
 * 2621: the quick brown fox jumps over the lazy dog in line 2621
 * 2622: the quick brown fox jumps over the lazy dog in line 2622
 * 2623: the quick brown fox jumps over the lazy dog in line 2623
 * 2624: the quick brown fox jumps over the lazy dog in line 2624
 * 2625: the quick brown fox jumps over the lazy dog in line 2625
 * 2626: the quick brown fox jumps over the lazy dog in line 2626
 * 2627: the quick brown fox jumps over the lazy dog in line 2627
 * 2628: the quick brown fox jumps over the lazy dog in line 2628
 * 2629: the quick brown fox jumps over the lazy dog in line 2629
 * 2630: the quick brown fox jumps over the lazy dog in line 2630
 * 2631: the quick brown fox jumps over the lazy dog in line 2631
 * 2632: the quick brown fox jumps over the lazy dog in line 2632
 * 2633: the quick brown fox jumps over the lazy dog in line 2633
 * 2634: the quick brown fox jumps over the lazy dog in line 2634
 * 2635: the quick brown fox jumps over the lazy dog in line 2635
 * 2636: the quick brown fox jumps over the lazy dog in line 2636
 * 2637: the quick brown fox jumps over the lazy dog in line 2637
 * 2638: the quick brown fox jumps over the lazy dog in line 2638
 * 2639: the quick brown fox jumps over the lazy dog in line 2639
 * 2640: the quick brown fox jumps over the lazy dog in line 2640
 * 2641: the quick brown fox jumps over the lazy dog in line 2641
 * 2642: the quick brown fox jumps over the lazy dog in line 2642
 * 2643: the quick brown fox jumps over the lazy dog in line 2643
 * 2644: the quick brown fox jumps over the lazy dog in line 2644
 * 2645: the quick brown fox jumps over the lazy dog in line 2645
 * 2646: the quick brown fox jumps over the lazy dog in line 2646
 * 2647: the quick brown fox jumps over the lazy dog in line 2647
 * 2648: the quick brown fox jumps over the lazy dog in line 2648
 * 2649: the quick brown fox jumps over the lazy dog in line 2649
 * 2650: the quick brown fox jumps over the lazy dog in line 2650
 * 2651: the quick brown fox jumps over the lazy dog in line 2651
 * 2652: the quick brown fox jumps over the lazy dog in line 2652
 * 2653: the quick brown fox jumps over the lazy dog in line 2653
 * 2654: the quick brown fox jumps over the lazy dog in line 2654
 * 2655: the quick brown fox jumps over the lazy dog in line 2655
 * 2656: the quick brown fox jumps over the lazy dog in line 2656
 * 2657: the quick brown fox jumps over the lazy dog in line 2657
 * 2658: the quick brown fox jumps over the lazy dog in line 2658
 * 2659: the quick brown fox jumps over the lazy dog in line 2659
 * 2660: the quick brown fox jumps over the lazy dog in line 2660
 * 2661: the quick brown fox jumps over the lazy dog in line 2661
 * 2662: the quick brown fox jumps over the lazy dog in line 2662
 * 2663: the quick brown fox jumps over the lazy dog in line 2663
 * 2664: the quick brown fox jumps over the lazy dog in line 2664
 * 2665: the quick brown fox jumps over the lazy dog in line 2665
 * 2666: the quick brown fox jumps over the lazy dog in line 2666
 * 2667: the quick brown fox jumps over the lazy dog in line 2667
 * 2668: the quick brown fox jumps over the lazy dog in line 2668
 * 2669: the quick brown fox jumps over the lazy dog in line 2669
 * 2670: the quick brown fox jumps over the lazy dog in line 2670
 * 2671: the quick brown fox jumps over the lazy dog in line 2671
 * 2672: the quick brown fox jumps over the lazy dog in line 2672
 * 2673: the quick brown fox jumps over the lazy dog in line 2673
 * 2674: the quick brown fox jumps over the lazy dog in line 2674
 * 2675: the quick brown fox jumps over the lazy dog in line 2675
 * 2676: the quick brown fox jumps over the lazy dog in line 2676
 * 2677: the quick brown fox jumps over the lazy dog in line 2677
 * 2678: the quick brown fox jumps over the lazy dog in line 2678
 * 2679: the quick brown fox jumps over the lazy dog in line 2679
 * 2680: the quick brown fox jumps over the lazy dog in line 2680
 * 2681: the quick brown fox jumps over the lazy dog in line 2681
 * 2682: the quick brown fox jumps over the lazy dog in line 2682
 * 2683: the quick brown fox jumps over the lazy dog in line 2683
 * 2684: the quick brown fox jumps over the lazy dog in line 2684
 * 2685: the quick brown fox jumps over the lazy dog in line 2685
 * 2686: the quick brown fox jumps over the lazy dog in line 2686
 * 2687: the quick brown fox jumps over the lazy dog in line 2687
 * 2688: the quick brown fox jumps over the lazy dog in line 2688
 * 2689: the quick brown fox jumps over the lazy dog in line 2689
 * 2690: the quick brown fox jumps over the lazy dog in line 2690
 * 2691: the quick brown fox jumps over the lazy dog in line 2691
 * 2692: the quick brown fox jumps over the lazy dog in line 2692
 * 2693: the quick brown fox jumps over the lazy dog in line 2693
 * 2694: the quick brown fox jumps over the lazy dog in line 2694
 * 2695: the quick brown fox jumps over the lazy dog in line 2695
 * 2696: the quick brown fox jumps over the lazy dog in line 2696
 * 2697: the quick brown fox jumps over the lazy dog in line 2697
 * 2698: the quick brown fox jumps over the lazy dog in line 2698
 * 2699: the quick brown fox jumps over the lazy dog in line 2699
 * 2700: the quick brown fox jumps over the lazy dog in line 2700
 * 2701: the quick brown fox jumps over the lazy dog in line 2701
 * 2702: the quick brown fox jumps over the lazy dog in line 2702
 * 2703: the quick brown fox jumps over the lazy dog in line 2703
 * 2704: the quick brown fox jumps over the lazy dog in line 2704
 * 2705: the quick brown fox jumps over the lazy dog in line 2705
 * 2706: the quick brown fox jumps over the lazy dog in line 2706
 * 2707: the quick brown fox jumps over the lazy dog in line 2707
 * 2708: the quick brown fox jumps over the lazy dog in line 2708
 * 2709: the quick brown fox jumps over the lazy dog in line 2709
 * 2710: the quick brown fox jumps over the lazy dog in line 2710
 * 2711: the quick brown fox jumps over the lazy dog in line 2711
 * 2712: the quick brown fox jumps over the lazy dog in line 2712
 * 2713: the quick brown fox jumps over the lazy dog in line 2713
 * 2714: the quick brown fox jumps over the lazy dog in line 2714
 * 2715: the quick brown fox jumps over the lazy dog in line 2715
 * 2716: the quick brown fox jumps over the lazy dog in line 2716
 * 2717: the quick brown fox jumps over the lazy dog in line 2717
 * 2718: the quick brown fox jumps over the lazy dog in line 2718
 * 2719: the quick brown fox jumps over the lazy dog in line 2719
 * 2720: the quick brown fox jumps over the lazy dog in line 2720
 * 2721: the quick brown fox jumps over the lazy dog in line 2721
 * 2722: the quick brown fox jumps over the lazy dog in line 2722
 * 2723: the quick brown fox jumps over the lazy dog in line 2723
 * 2724: the quick brown fox jumps over the lazy dog in line 2724
 * 2725: the quick brown fox jumps over the lazy dog in line 2725
 * 2726: the quick brown fox jumps over the lazy dog in line 2726
 * 2727: the quick brown fox jumps over the lazy dog in line 2727
 * 2728: the quick brown fox jumps over the lazy dog in line 2728
 * 2729: the quick brown fox jumps over the lazy dog in line 2729
 * 2730: the quick brown fox jumps over the lazy dog in line 2730
 * 2731: the quick brown fox jumps over the lazy dog in line 2731
 * 2732: the quick brown fox jumps over the lazy dog in line 2732
 * 2733: the quick brown fox jumps over the lazy dog in line 2733
 * 2734: the quick brown fox jumps over the lazy dog in line 2734
 * 2735: the quick brown fox jumps over the lazy dog in line 2735
 * 2736: the quick brown fox jumps over the lazy dog in line 2736
 * 2737: the quick brown fox jumps over the lazy dog in line 2737
 * 2738: the quick brown fox jumps over the lazy dog in line 2738
 * 2739: the quick brown fox jumps over the lazy dog in line 2739
 * 2740: the quick brown fox jumps over the lazy dog in line 2740
 * 2741: the quick brown fox jumps over the lazy dog in line 2741
 * 2742: the quick brown fox jumps over the lazy dog in line 2742
 * 2743: the quick brown fox jumps over the lazy dog in line 2743
 * 2744: the quick brown fox jumps over the lazy dog in line 2744
 * 2745: the quick brown fox jumps over the lazy dog in line 2745
 * 2746: the quick brown fox jumps over the lazy dog in line 2746
 * 2747: the quick brown fox jumps over the lazy dog in line 2747
 * 2748: the quick brown fox jumps over the lazy dog in line 2748
 * 2749: the quick brown fox jumps over the lazy dog in line 2749
 * 2750: the quick brown fox jumps over the lazy dog in line 2750
 * 2751: the quick brown fox jumps over the lazy dog in line 2751
 * 2752: the quick brown fox jumps over the lazy dog in line 2752
 * 2753: the quick brown fox jumps over the lazy dog in line 2753
 * 2754: the quick brown fox jumps over the lazy dog in line 2754
 * 2755: the quick brown fox jumps over the lazy dog in line 2755
 * 2756: the quick brown fox jumps over the lazy dog in line 2756
 * 2757: the quick brown fox jumps over the lazy dog in line 2757
 * 2758: the quick brown fox jumps over the lazy dog in line 2758
 * 2759: the quick brown fox jumps over the lazy dog in line 2759
 * 2760: the quick brown fox jumps over the lazy dog in line 2760
 * 2761: the quick brown fox jumps over the lazy dog in line 2761
 * 2762: the quick brown fox jumps over the lazy dog in line 2762
 * 2763: the quick brown fox jumps over the lazy dog in line 2763
 * 2764: the quick brown fox jumps over the lazy dog in line 2764
 * 2765: the quick brown fox jumps over the lazy dog in line 2765
 * 2766: the quick brown fox jumps over the lazy dog in line 2766
 * 2767: the quick brown fox jumps over the lazy dog in line 2767
 * 2768: the quick brown fox jumps over the lazy dog in line 2768
 * 2769: the quick brown fox jumps over the lazy dog in line 2769
 * 2770: the quick brown fox jumps over the lazy dog in line 2770
 * 2771: the quick brown fox jumps over the lazy dog in line 2771
 * 2772: the quick brown fox jumps over the lazy dog in line 2772
 * 2773: the quick brown fox jumps over the lazy dog in line 2773
 * 2774: the quick brown fox jumps over the lazy dog in line 2774
 * 2775: the quick brown fox jumps over the lazy dog in line 2775
 * 2776: the quick brown fox jumps over the lazy dog in line 2776
 * 2777: the quick brown fox jumps over the lazy dog in line 2777
 * 2778: the quick brown fox jumps over the lazy dog in line 2778
 * 2779: the quick brown fox jumps over the lazy dog in line 2779
 * 2780: the quick brown fox jumps over the lazy dog in line 2780
 * 2781: the quick brown fox jumps over the lazy dog in line 2781
 * 2782: the quick brown fox jumps over the lazy dog in line 2782
 * 2783: the quick brown fox jumps over the lazy dog in line 2783
 * 2784: the quick brown fox jumps over the lazy dog in line 2784
 * 2785: the quick brown fox jumps over the lazy dog in line 2785
 * 2786: the quick brown fox jumps over the lazy dog in line 2786
 * 2787: the quick brown fox jumps over the lazy dog in line 2787
 * 2788: the quick brown fox jumps over the lazy dog in line 2788
 * 2789: the quick brown fox jumps over the lazy dog in line 2789
 * 2790: the quick brown fox jumps over the lazy dog in line 2790
 * 2791: the quick brown fox jumps over the lazy dog in line 2791
 * 2792: the quick brown fox jumps over the lazy dog in line 2792
 * 2793: the quick brown fox jumps over the lazy dog in line 2793
 * 2794: the quick brown fox jumps over the lazy dog in line 2794
 * 2795: the quick brown fox jumps over the lazy dog in line 2795
 * 2796: the quick brown fox jumps over the lazy dog in line 2796
 * 2797: the quick brown fox jumps over the lazy dog in line 2797
 * 2798: the quick brown fox jumps over the lazy dog in line 2798
 * 2799: the quick brown fox jumps over the lazy dog in line 2799
 * 2800: the quick brown fox jumps over the lazy dog in line 2800
 * 2801: the quick brown fox jumps over the lazy dog in line 2801
 * 2802: the quick brown fox jumps over the lazy dog in line 2802
 * 2803: the quick brown fox jumps over the lazy dog in line 2803
 * 2804: the quick brown fox jumps over the lazy dog in line 2804
 * 2805: the quick brown fox jumps over the lazy dog in line 2805
 * 2806: the quick brown fox jumps over the lazy dog in line 2806
 * 2807: the quick brown fox jumps over the lazy dog in line 2807
 * 2808: the quick brown fox jumps over the lazy dog in line 2808
 * 2809: the quick brown fox jumps over the lazy dog in line 2809
 * 2810: the quick brown fox jumps over the lazy dog in line 2810
 * 2811: the quick brown fox jumps over the lazy dog in line 2811
 * 2812: the quick brown fox jumps over the lazy dog in line 2812
 * 2813: the quick brown fox jumps over the lazy dog in line 2813
 * 2814: the quick brown fox jumps over the lazy dog in line 2814
 * 2815: the quick brown fox jumps over the lazy dog in line 2815
 * 2816: the quick brown fox jumps over the lazy dog in line 2816
 * 2817: the quick brown fox jumps over the lazy dog in line 2817
 * 2818: the quick brown fox jumps over the lazy dog in line 2818
 * 2819: the quick brown fox jumps over the lazy dog in line 2819
 * 2820: the quick brown fox jumps over the lazy dog in line 2820
 * 2821: the quick brown fox jumps over the lazy dog in line 2821
 * 2822: the quick brown fox jumps over the lazy dog in line 2822
 * 2823: the quick brown fox jumps over the lazy dog in line 2823
 * 2824: the quick brown fox jumps over the lazy dog in line 2824
 * 2825: the quick brown fox jumps over the lazy dog in line 2825
 * 2826: the quick brown fox jumps over the lazy dog in line 2826
 * 2827: the quick brown fox jumps over the lazy dog in line 2827
 * 2828: the quick brown fox jumps over the lazy dog in line 2828
 * 2829: the quick brown fox jumps over the lazy dog in line 2829
 * 2830: the quick brown fox jumps over the lazy dog in line 2830
 * 2831: the quick brown fox jumps over the lazy dog in line 2831
 * 2832: the quick brown fox jumps over the lazy dog in line 2832
 * 2833: the quick brown fox jumps over the lazy dog in line 2833
 * 2834: the quick brown fox jumps over the lazy dog in line 2834
 * 2835: the quick brown fox jumps over the lazy dog in line 2835
 * 2836: the quick brown fox jumps over the lazy dog in line 2836
 * 2837: the quick brown fox jumps over the lazy dog in line 2837
 * 2838: the quick brown fox jumps over the lazy dog in line 2838
 * 2839: the quick brown fox jumps over the lazy dog in line 2839
 * 2840: the quick brown fox jumps over the lazy dog in line 2840
 * 2841: the quick brown fox jumps over the lazy dog in line 2841
 * 2842: the quick brown fox jumps over the lazy dog in line 2842
 * 2843: the quick brown fox jumps over the lazy dog in line 2843
 * 2844: the quick brown fox jumps over the lazy dog in line 2844
 * 2845: the quick brown fox jumps over the lazy dog in line 2845
 * 2846: the quick brown fox jumps over the lazy dog in line 2846
 * 2847: the quick brown fox jumps over the lazy dog in line 2847
 * 2848: the quick brown fox jumps over the lazy dog in line 2848
 * 2849: the quick brown fox jumps over the lazy dog in line 2849
 * 2850: the quick brown fox jumps over the lazy dog in line 2850
 * 2851: the quick brown fox jumps over the lazy dog in line 2851
 * 2852: the quick brown fox jumps over the lazy dog in line 2852
 * 2853: the quick brown fox jumps over the lazy dog in line 2853
 * 2854: the quick brown fox jumps over the lazy dog in line 2854
 * 2855: the quick brown fox jumps over the lazy dog in line 2855
 * 2856: the quick brown fox jumps over the lazy dog in line 2856
 * 2857: the quick brown fox jumps over the lazy dog in line 2857
 * 2858: the quick brown fox jumps over the lazy dog in line 2858
 * 2859: the quick brown fox jumps over the lazy dog in line 2859
 * 2860: the quick brown fox jumps over the lazy dog in line 2860
 * 2861: the quick brown fox jumps over the lazy dog in line 2861
 * 2862: the quick brown fox jumps over the lazy dog in line 2862
 * 2863: the quick brown fox jumps over the lazy dog in line 2863
 * 2864: the quick brown fox jumps over the lazy dog in line 2864
 * 2865: the quick brown fox jumps over the lazy dog in line 2865
 * 2866: the quick brown fox jumps over the lazy dog in line 2866
 * 2867: the quick brown fox jumps over the lazy dog in line 2867
 * 2868: the quick brown fox jumps over the lazy dog in line 2868
 * 2869: the quick brown fox jumps over the lazy dog in line 2869
 * 2870: the quick brown fox jumps over the lazy dog in line 2870
 * 2871: the quick brown fox jumps over the lazy dog in line 2871
 * 2872: the quick brown fox jumps over the lazy dog in line 2872
 * 2873: the quick brown fox jumps over the lazy dog in line 2873
 * 2874: the quick brown fox jumps over the lazy dog in line 2874
 * 2875: the quick brown fox jumps over the lazy dog in line 2875
 * 2876: the quick brown fox jumps over the lazy dog in line 2876
 * 2877: the quick brown fox jumps over the lazy dog in line 2877
 * 2878: the quick brown fox jumps over the lazy dog in line 2878
 * 2879: the quick brown fox jumps over the lazy dog in line 2879
 * 2880: the quick brown fox jumps over the lazy dog in line 2880
 * 2881: the quick brown fox jumps over the lazy dog in line 2881
 * 2882: the quick brown fox jumps over the lazy dog in line 2882
 * 2883: the quick brown fox jumps over the lazy dog in line 2883
 * 2884: the quick brown fox jumps over the lazy dog in line 2884
 * 2885: the quick brown fox jumps over the lazy dog in line 2885
 * 2886: the quick brown fox jumps over the lazy dog in line 2886
 * 2887: the quick brown fox jumps over the lazy dog in line 2887
 * 2888: the quick brown fox jumps over the lazy dog in line 2888
 * 2889: the quick brown fox jumps over the lazy dog in line 2889
 * 2890: the quick brown fox jumps over the lazy dog in line 2890
 * 2891: the quick brown fox jumps over the lazy dog in line 2891
 * 2892: the quick brown fox jumps over the lazy dog in line 2892
 * 2893: the quick brown fox jumps over the lazy dog in line 2893
 * 2894: the quick brown fox jumps over the lazy dog in line 2894
 * 2895: the quick brown fox jumps over the lazy dog in line 2895
 * 2896: the quick brown fox jumps over the lazy dog in line 2896
 * 2897: the quick brown fox jumps over the lazy dog in line 2897
 * 2898: the quick brown fox jumps over the lazy dog in line 2898
 * 2899: the quick brown fox jumps over the lazy dog in line 2899
 * 2900: the quick brown fox jumps over the lazy dog in line 2900
 * 2901: the quick brown fox jumps over the lazy dog in line 2901
 * 2902: the quick brown fox jumps over the lazy dog in line 2902
 * 2903: the quick brown fox jumps over the lazy dog in line 2903
 * 2904: the quick brown fox jumps over the lazy dog in line 2904
 * 2905: the quick brown fox jumps over the lazy dog in line 2905
 * 2906: the quick brown fox jumps over the lazy dog in line 2906
 * 2907: the quick brown fox jumps over the lazy dog in line 2907
 * 2908: the quick brown fox jumps over the lazy dog in line 2908
 * 2909: the quick brown fox jumps over the lazy dog in line 2909
 * 2910: the quick brown fox jumps over the lazy dog in line 2910
 * 2911: the quick brown fox jumps over the lazy dog in line 2911
 * 2912: the quick brown fox jumps over the lazy dog in line 2912
 * 2913: the quick brown fox jumps over the lazy dog in line 2913
 * 2914: the quick brown fox jumps over the lazy dog in line 2914
 * 2915: the quick brown fox jumps over the lazy dog in line 2915
 * 2916: the quick brown fox jumps over the lazy dog in line 2916
 * 2917: the quick brown fox jumps over the lazy dog in line 2917
 * 2918: the quick brown fox jumps over the lazy dog in line 2918
 * 2919: the quick brown fox jumps over the lazy dog in line 2919
 * 2920: the quick brown fox jumps over the lazy dog in line 2920
 * 2921: the quick brown fox jumps over the lazy dog in line 2921
 * 2922: the quick brown fox jumps over the lazy dog in line 2922
 * 2923: the quick brown fox jumps over the lazy dog in line 2923
 * 2924: the quick brown fox jumps over the lazy dog in line 2924
 * 2925: the quick brown fox jumps over the lazy dog in line 2925
 * 2926: the quick brown fox jumps over the lazy dog in line 2926
 * 2927: the quick brown fox jumps over the lazy dog in line 2927
 * 2928: the quick brown fox jumps over the lazy dog in line 2928
 * 2929: the quick brown fox jumps over the lazy dog in line 2929
 * 2930: the quick brown fox jumps over the lazy dog in line 2930
 * 2931: the quick brown fox jumps over the lazy dog in line 2931
 * 2932: the quick brown fox jumps over the lazy dog in line 2932
 * 2933: the quick brown fox jumps over the lazy dog in line 2933
 * 2934: the quick brown fox jumps over the lazy dog in line 2934
 * 2935: the quick brown fox jumps over the lazy dog in line 2935
 * 2936: the quick brown fox jumps over the lazy dog in line 2936
 * 2937: the quick brown fox jumps over the lazy dog in line 2937
 * 2938: the quick brown fox jumps over the lazy dog in line 2938
 * 2939: the quick brown fox jumps over the lazy dog in line 2939
 * 2940: the quick brown fox jumps over the lazy dog in line 2940
 * 2941: the quick brown fox jumps over the lazy dog in line 2941
 * 2942: the quick brown fox jumps over the lazy dog in line 2942
 * 2943: the quick brown fox jumps over the lazy dog in line 2943
 * 2944: the quick brown fox jumps over the lazy dog in line 2944
 * 2945: the quick brown fox jumps over the lazy dog in line 2945
 * 2946: the quick brown fox jumps over the lazy dog in line 2946
 * 2947: the quick brown fox jumps over the lazy dog in line 2947
 * 2948: the quick brown fox jumps over the lazy dog in line 2948
 * 2949: the quick brown fox jumps over the lazy dog in line 2949
 * 2950: the quick brown fox jumps over the lazy dog in line 2950
 * 2951: the quick brown fox jumps over the lazy dog in line 2951
 * 2952: the quick brown fox jumps over the lazy dog in line 2952
 * 2953: the quick brown fox jumps over the lazy dog in line 2953
 * 2954: the quick brown fox jumps over the lazy dog in line 2954
 * 2955: the quick brown fox jumps over the lazy dog in line 2955
 * 2956: the quick brown fox jumps over the lazy dog in line 2956
 * 2957: the quick brown fox jumps over the lazy dog in line 2957
 * 2958: the quick brown fox jumps over the lazy dog in line 2958
 * 2959: the quick brown fox jumps over the lazy dog in line 2959
 * 2960: the quick brown fox jumps over the lazy dog in line 2960
 * 2961: the quick brown fox jumps over the lazy dog in line 2961
 * 2962: the quick brown fox jumps over the lazy dog in line 2962
 * 2963: the quick brown fox jumps over the lazy dog in line 2963
 * 2964: the quick brown fox jumps over the lazy dog in line 2964
 * 2965: the quick brown fox jumps over the lazy dog in line 2965
 * 2966: the quick brown fox jumps over the lazy dog in line 2966
 * 2967: the quick brown fox jumps over the lazy dog in line 2967
 * 2968: the quick brown fox jumps over the lazy dog in line 2968
 * 2969: the quick brown fox jumps over the lazy dog in line 2969
 * 2970: the quick brown fox jumps over the lazy dog in line 2970
 * 2971: the quick brown fox jumps over the lazy dog in line 2971
 * 2972: the quick brown fox jumps over the lazy dog in line 2972
 * 2973: the quick brown fox jumps over the lazy dog in line 2973
 * 2974: the quick brown fox jumps over the lazy dog in line 2974
 * 2975: the quick brown fox jumps over the lazy dog in line 2975
 * 2976: the quick brown fox jumps over the lazy dog in line 2976
 * 2977: the quick brown fox jumps over the lazy dog in line 2977
 * 2978: the quick brown fox jumps over the lazy dog in line 2978
 * 2979: the quick brown fox jumps over the lazy dog in line 2979
 * 2980: the quick brown fox jumps over the lazy dog in line 2980
 * 2981: the quick brown fox jumps over the lazy dog in line 2981
 * 2982: the quick brown fox jumps over the lazy dog in line 2982
 * 2983: the quick brown fox jumps over the lazy dog in line 2983
 * 2984: the quick brown fox jumps over the lazy dog in line 2984
 * 2985: the quick brown fox jumps over the lazy dog in line 2985
 * 2986: the quick brown fox jumps over the lazy dog in line 2986
 * 2987: the quick brown fox jumps over the lazy dog in line 2987
 * 2988: the quick brown fox jumps over the lazy dog in line 2988
 * 2989: the quick brown fox jumps over the lazy dog in line 2989
 * 2990: the quick brown fox jumps over the lazy dog in line 2990
 * 2991: the quick brown fox jumps over the lazy dog in line 2991
 * 2992: the quick brown fox jumps over the lazy dog in line 2992
 * 2993: the quick brown fox jumps over the lazy dog in line 2993
 * 2994: the quick brown fox jumps over the lazy dog in line 2994
 * 2995: the quick brown fox jumps over the lazy dog in line 2995
 * 2996: the quick brown fox jumps over the lazy dog in line 2996
 * 2997: the quick brown fox jumps over the lazy dog in line 2997
 * 2998: the quick brown fox jumps over the lazy dog in line 2998
 * 2999: the quick brown fox jumps over the lazy dog in line 2999
 */
struct Family { uint32_t node, left, right; };
static const Family families[] = {
    {0, 1, 2}, // ########################################
    {1, 3, 4},
    {2, 5, 6},
    {3, 7, 8},
    {4, 9, 10},
    {5, 11, 12},
    {6, 13, 14},
    {7, 15, 16},
    {8, 17, 18},
    {9, 19, 20},
    {10, 21, 22},
    {11, 23, 24},
    {12, 25, 26},
    {13, 27, 28},
    {14, 29, 30},
    {15, 31, 32},
    {16, 33, 34},
    {17, 35, 36},
    {18, 37, 38},
    {19, 39, 40},
    {20, 41, 42},
    {21, 43, 44},
    {22, 45, 46},
    {23, 47, 48},
    {24, 49, 50},
    {25, 51, 52},
    {26, 53, 54},
    {27, 55, 56},
    {28, 57, 58},
    {29, 59, 60},
    {30, 61, 62},
    {31, 63, 64},
    {32, 65, 66},
    {33, 67, 68},
    {34, 69, 70},
    {35, 71, 72},
    {36, 73, 74},
    {37, 75, 76},
    {38, 77, 78},
    {39, 79, 80},
    {40, 81, 82},
    {41, 83, 84},
    {42, 85, 86},
    {43, 87, 88},
    {44, 89, 90},
    {45, 91, 92},
    {46, 93, 94},
    {47, 95, 96},
    {48, 97, 98},
    {49, 99, 100},
    {50, 101, 102},
    {51, 103, 104},
    {52, 105, 106},
    {53, 107, 108},
    {54, 109, 110},
    {55, 111, 112},
    {56, 113, 114},
    {57, 115, 116},
    {58, 117, 118},
    {59, 119, 120},
    {60, 121, 122},
    {61, 123, 124},
    {62, 125, 126},
    {63, 127, 128},
    {64, 129, 130}, // ########################################
    {65, 131, 132},
    {66, 133, 134},
    {67, 135, 136},
    {68, 137, 138},
    {69, 139, 140},
    {70, 141, 142},
    {71, 143, 144},
    {72, 145, 146},
    {73, 147, 148},
    {74, 149, 150},
    {75, 151, 152},
    {76, 153, 154},
    {77, 155, 156},
    {78, 157, 158},
    {79, 159, 160},
    {80, 161, 162},
    {81, 163, 164},
    {82, 165, 166},
    {83, 167, 168},
    {84, 169, 170},
    {85, 171, 172},
    {86, 173, 174},
    {87, 175, 176},
    {88, 177, 178},
    {89, 179, 180},
    {90, 181, 182},
    {91, 183, 184},
    {92, 185, 186},
    {93, 187, 188},
    {94, 189, 190},
    {95, 191, 192},
    {96, 193, 194},
    {97, 195, 196},
    {98, 197, 198},
    {99, 199, 200},
    {100, 201, 202},
    {101, 203, 204},
    {102, 205, 206},
    {103, 207, 208},
    {104, 209, 210},
    {105, 211, 212},
    {106, 213, 214},
    {107, 215, 216},
    {108, 217, 218},
    {109, 219, 220},
    {110, 221, 222},
    {111, 223, 224},
    {112, 225, 226},
    {113, 227, 228},
    {114, 229, 230},
    {115, 231, 232},
    {116, 233, 234},
    {117, 235, 236},
    {118, 237, 238},
    {119, 239, 240},
    {120, 241, 242},
    {121, 243, 244},
    {122, 245, 246},
    {123, 247, 248},
    {124, 249, 250},
    {125, 251, 252},
    {126, 253, 254},
    {127, 255, 256},
    {128, 257, 258}, // ########################################
    {129, 259, 260},
    {130, 261, 262},
    {131, 263, 264},
    {132, 265, 266},
    {133, 267, 268},
    {134, 269, 270},
    {135, 271, 272},
    {136, 273, 274},
    {137, 275, 276},
    {138, 277, 278},
    {139, 279, 280},
    {140, 281, 282},
    {141, 283, 284},
    {142, 285, 286},
    {143, 287, 288},
    {144, 289, 290},
    {145, 291, 292},
    {146, 293, 294},
    {147, 295, 296},
    {148, 297, 298},
    {149, 299, 300},
    {150, 301, 302},
    {151, 303, 304},
    {152, 305, 306},
    {153, 307, 308},
    {154, 309, 310},
    {155, 311, 312},
    {156, 313, 314},
    {157, 315, 316},
    {158, 317, 318},
    {159, 319, 320},
    {160, 321, 322},
    {161, 323, 324},
    {162, 325, 326},
    {163, 327, 328},
    {164, 329, 330},
    {165, 331, 332},
    {166, 333, 334},
    {167, 335, 336},
    {168, 337, 338},
    {169, 339, 340},
    {170, 341, 342},
    {171, 343, 344},
    {172, 345, 346},
    {173, 347, 348},
    {174, 349, 350},
    {175, 351, 352},
    {176, 353, 354},
    {177, 355, 356},
    {178, 357, 358},
    {179, 359, 360},
    {180, 361, 362},
    {181, 363, 364},
    {182, 365, 366},
    {183, 367, 368},
    {184, 369, 370},
    {185, 371, 372},
    {186, 373, 374},
    {187, 375, 376},
    {188, 377, 378},
    {189, 379, 380},
    {190, 381, 382},
    {191, 383, 384},
    {192, 385, 386}, // ########################################
    {193, 387, 388},
    {194, 389, 390},
    {195, 391, 392},
    {196, 393, 394},
    {197, 395, 396},
    {198, 397, 398},
    {199, 399, 400},
    {200, 401, 402},
    {201, 403, 404},
    {202, 405, 406},
    {203, 407, 408},
    {204, 409, 410},
    {205, 411, 412},
    {206, 413, 414},
    {207, 415, 416},
    {208, 417, 418},
    {209, 419, 420},
    {210, 421, 422},
    {211, 423, 424},
    {212, 425, 426},
    {213, 427, 428},
    {214, 429, 430},
    {215, 431, 432},
    {216, 433, 434},
    {217, 435, 436},
    {218, 437, 438},
    {219, 439, 440},
    {220, 441, 442},
    {221, 443, 444},
    {222, 445, 446},
    {223, 447, 448},
    {224, 449, 450},
    {225, 451, 452},
    {226, 453, 454},
    {227, 455, 456},
    {228, 457, 458},
    {229, 459, 460},
    {230, 461, 462},
    {231, 463, 464},
    {232, 465, 466},
    {233, 467, 468},
    {234, 469, 470},
    {235, 471, 472},
    {236, 473, 474},
    {237, 475, 476},
    {238, 477, 478},
    {239, 479, 480},
    {240, 481, 482},
    {241, 483, 484},
    {242, 485, 486},
    {243, 487, 488},
    {244, 489, 490},
    {245, 491, 492},
    {246, 493, 494},
    {247, 495, 496},
    {248, 497, 498},
    {249, 499, 500},
    {250, 501, 502},
    {251, 503, 504},
    {252, 505, 506},
    {253, 507, 508},
    {254, 509, 510},
    {255, 511, 512},
    {256, 513, 514}, // ########################################
    {257, 515, 516},
    {258, 517, 518},
    {259, 519, 520},
    {260, 521, 522},
    {261, 523, 524},
    {262, 525, 526},
    {263, 527, 528},
    {264, 529, 530},
    {265, 531, 532},
    {266, 533, 534},
    {267, 535, 536},
    {268, 537, 538},
    {269, 539, 540},
    {270, 541, 542},
    {271, 543, 544},
    {272, 545, 546},
    {273, 547, 548},
    {274, 549, 550},
    {275, 551, 552},
    {276, 553, 554},
    {277, 555, 556},
    {278, 557, 558},
    {279, 559, 560},
    {280, 561, 562},
    {281, 563, 564},
    {282, 565, 566},
    {283, 567, 568},
    {284, 569, 570},
    {285, 571, 572},
    {286, 573, 574},
    {287, 575, 576},
    {288, 577, 578},
    {289, 579, 580},
    {290, 581, 582},
    {291, 583, 584},
    {292, 585, 586},
    {293, 587, 588},
    {294, 589, 590},
    {295, 591, 592},
    {296, 593, 594},
    {297, 595, 596},
    {298, 597, 598},
    {299, 599, 600},
    {300, 601, 602},
    {301, 603, 604},
    {302, 605, 606},
    {303, 607, 608},
    {304, 609, 610},
    {305, 611, 612},
    {306, 613, 614},
    {307, 615, 616},
    {308, 617, 618},
    {309, 619, 620},
    {310, 621, 622},
    {311, 623, 624},
    {312, 625, 626},
    {313, 627, 628},
    {314, 629, 630},
    {315, 631, 632},
    {316, 633, 634},
    {317, 635, 636},
    {318, 637, 638},
    {319, 639, 640},
    {320, 641, 642}, // ########################################
    {321, 643, 644},
    {322, 645, 646},
    {323, 647, 648},
    {324, 649, 650},
    {325, 651, 652},
    {326, 653, 654},
    {327, 655, 656},
    {328, 657, 658},
    {329, 659, 660},
    {330, 661, 662},
    {331, 663, 664},
    {332, 665, 666},
    {333, 667, 668},
    {334, 669, 670},
    {335, 671, 672},
    {336, 673, 674},
    {337, 675, 676},
    {338, 677, 678},
    {339, 679, 680},
    {340, 681, 682},
    {341, 683, 684},
    {342, 685, 686},
    {343, 687, 688},
    {344, 689, 690},
    {345, 691, 692},
    {346, 693, 694},
    {347, 695, 696},
    {348, 697, 698},
    {349, 699, 700},
    {350, 701, 702},
    {351, 703, 704},
    {352, 705, 706},
    {353, 707, 708},
    {354, 709, 710},
    {355, 711, 712},
    {356, 713, 714},
    {357, 715, 716},
    {358, 717, 718},
    {359, 719, 720},
    {360, 721, 722},
    {361, 723, 724},
    {362, 725, 726},
    {363, 727, 728},
    {364, 729, 730},
    {365, 731, 732},
    {366, 733, 734},
    {367, 735, 736},
    {368, 737, 738},
    {369, 739, 740},
    {370, 741, 742},
    {371, 743, 744},
    {372, 745, 746},
    {373, 747, 748},
    {374, 749, 750},
    {375, 751, 752},
    {376, 753, 754},
    {377, 755, 756},
    {378, 757, 758},
    {379, 759, 760},
    {380, 761, 762},
    {381, 763, 764},
    {382, 765, 766},
    {383, 767, 768},
    {384, 769, 770}, // ########################################
    {385, 771, 772},
    {386, 773, 774},
    {387, 775, 776},
    {388, 777, 778},
    {389, 779, 780},
    {390, 781, 782},
    {391, 783, 784},
    {392, 785, 786},
    {393, 787, 788},
    {394, 789, 790},
    {395, 791, 792},
    {396, 793, 794},
    {397, 795, 796},
    {398, 797, 798},
    {399, 799, 800},
    {400, 801, 802},
    {401, 803, 804},
    {402, 805, 806},
    {403, 807, 808},
    {404, 809, 810},
    {405, 811, 812},
    {406, 813, 814},
    {407, 815, 816},
    {408, 817, 818},
    {409, 819, 820},
    {410, 821, 822},
    {411, 823, 824},
    {412, 825, 826},
    {413, 827, 828},
    {414, 829, 830},
    {415, 831, 832},
    {416, 833, 834},
    {417, 835, 836},
    {418, 837, 838},
    {419, 839, 840},
    {420, 841, 842},
    {421, 843, 844},
    {422, 845, 846},
    {423, 847, 848},
    {424, 849, 850},
    {425, 851, 852},
    {426, 853, 854},
    {427, 855, 856},
    {428, 857, 858},
    {429, 859, 860},
    {430, 861, 862},
    {431, 863, 864},
    {432, 865, 866},
    {433, 867, 868},
    {434, 869, 870},
    {435, 871, 872},
    {436, 873, 874},
    {437, 875, 876},
    {438, 877, 878},
    {439, 879, 880},
    {440, 881, 882},
    {441, 883, 884},
    {442, 885, 886},
    {443, 887, 888},
    {444, 889, 890},
    {445, 891, 892},
    {446, 893, 894},
    {447, 895, 896},
    {448, 897, 898}, // ########################################
    {449, 899, 900},
    {450, 901, 902},
    {451, 903, 904},
    {452, 905, 906},
    {453, 907, 908},
    {454, 909, 910},
    {455, 911, 912},
    {456, 913, 914},
    {457, 915, 916},
    {458, 917, 918},
    {459, 919, 920},
    {460, 921, 922},
    {461, 923, 924},
    {462, 925, 926},
    {463, 927, 928},
    {464, 929, 930},
    {465, 931, 932},
    {466, 933, 934},
    {467, 935, 936},
    {468, 937, 938},
    {469, 939, 940},
    {470, 941, 942},
    {471, 943, 944},
    {472, 945, 946},
    {473, 947, 948},
    {474, 949, 950},
    {475, 951, 952},
    {476, 953, 954},
    {477, 955, 956},
    {478, 957, 958},
    {479, 959, 960},
    {480, 961, 962},
    {481, 963, 964},
    {482, 965, 966},
    {483, 967, 968},
    {484, 969, 970},
    {485, 971, 972},
    {486, 973, 974},
    {487, 975, 976},
    {488, 977, 978},
    {489, 979, 980},
    {490, 981, 982},
    {491, 983, 984},
    {492, 985, 986},
    {493, 987, 988},
    {494, 989, 990},
    {495, 991, 992},
    {496, 993, 994},
    {497, 995, 996},
    {498, 997, 998},
    {499, 999, 1000},
    {500, 1001, 1002},
    {501, 1003, 1004},
    {502, 1005, 1006},
    {503, 1007, 1008},
    {504, 1009, 1010},
    {505, 1011, 1012},
    {506, 1013, 1014},
    {507, 1015, 1016},
    {508, 1017, 1018},
    {509, 1019, 1020},
    {510, 1021, 1022},
    {511, 1023, 1024},
    {512, 1025, 1026}, // ########################################
    {513, 1027, 1028},
    {514, 1029, 1030},
    {515, 1031, 1032},
    {516, 1033, 1034},
    {517, 1035, 1036},
    {518, 1037, 1038},
    {519, 1039, 1040},
    {520, 1041, 1042},
    {521, 1043, 1044},
    {522, 1045, 1046},
    {523, 1047, 1048},
    {524, 1049, 1050},
    {525, 1051, 1052},
    {526, 1053, 1054},
    {527, 1055, 1056},
    {528, 1057, 1058},
    {529, 1059, 1060},
    {530, 1061, 1062},
    {531, 1063, 1064},
    {532, 1065, 1066},
    {533, 1067, 1068},
    {534, 1069, 1070},
    {535, 1071, 1072},
    {536, 1073, 1074},
    {537, 1075, 1076},
    {538, 1077, 1078},
    {539, 1079, 1080},
    {540, 1081, 1082},
    {541, 1083, 1084},
    {542, 1085, 1086},
    {543, 1087, 1088},
    {544, 1089, 1090},
    {545, 1091, 1092},
    {546, 1093, 1094},
    {547, 1095, 1096},
    {548, 1097, 1098},
    {549, 1099, 1100},
    {550, 1101, 1102},
    {551, 1103, 1104},
    {552, 1105, 1106},
    {553, 1107, 1108},
    {554, 1109, 1110},
    {555, 1111, 1112},
    {556, 1113, 1114},
    {557, 1115, 1116},
    {558, 1117, 1118},
    {559, 1119, 1120},
    {560, 1121, 1122},
    {561, 1123, 1124},
    {562, 1125, 1126},
    {563, 1127, 1128},
    {564, 1129, 1130},
    {565, 1131, 1132},
    {566, 1133, 1134},
    {567, 1135, 1136},
    {568, 1137, 1138},
    {569, 1139, 1140},
    {570, 1141, 1142},
    {571, 1143, 1144},
    {572, 1145, 1146},
    {573, 1147, 1148},
    {574, 1149, 1150},
    {575, 1151, 1152},
    {576, 1153, 1154}, // ########################################
    {577, 1155, 1156},
    {578, 1157, 1158},
    {579, 1159, 1160},
    {580, 1161, 1162},
    {581, 1163, 1164},
    {582, 1165, 1166},
    {583, 1167, 1168},
    {584, 1169, 1170},
    {585, 1171, 1172},
    {586, 1173, 1174},
    {587, 1175, 1176},
    {588, 1177, 1178},
    {589, 1179, 1180},
    {590, 1181, 1182},
    {591, 1183, 1184},
    {592, 1185, 1186},
    {593, 1187, 1188},
    {594, 1189, 1190},
    {595, 1191, 1192},
    {596, 1193, 1194},
    {597, 1195, 1196},
    {598, 1197, 1198},
    {599, 1199, 1200},
    {600, 1201, 1202},
    {601, 1203, 1204},
    {602, 1205, 1206},
    {603, 1207, 1208},
    {604, 1209, 1210},
    {605, 1211, 1212},
    {606, 1213, 1214},
    {607, 1215, 1216},
    {608, 1217, 1218},
    {609, 1219, 1220},
    {610, 1221, 1222},
    {611, 1223, 1224},
    {612, 1225, 1226},
    {613, 1227, 1228},
    {614, 1229, 1230},
    {615, 1231, 1232},
    {616, 1233, 1234},
    {617, 1235, 1236},
    {618, 1237, 1238},
    {619, 1239, 1240},
    {620, 1241, 1242},
    {621, 1243, 1244},
    {622, 1245, 1246},
    {623, 1247, 1248},
    {624, 1249, 1250},
    {625, 1251, 1252},
    {626, 1253, 1254},
    {627, 1255, 1256},
    {628, 1257, 1258},
    {629, 1259, 1260},
    {630, 1261, 1262},
    {631, 1263, 1264},
    {632, 1265, 1266},
    {633, 1267, 1268},
    {634, 1269, 1270},
    {635, 1271, 1272},
    {636, 1273, 1274},
    {637, 1275, 1276},
    {638, 1277, 1278},
    {639, 1279, 1280},
    {640, 1281, 1282}, // ########################################
    {641, 1283, 1284},
    {642, 1285, 1286},
    {643, 1287, 1288},
    {644, 1289, 1290},
    {645, 1291, 1292},
    {646, 1293, 1294},
    {647, 1295, 1296},
    {648, 1297, 1298},
    {649, 1299, 1300},
    {650, 1301, 1302},
    {651, 1303, 1304},
    {652, 1305, 1306},
    {653, 1307, 1308},
    {654, 1309, 1310},
    {655, 1311, 1312},
    {656, 1313, 1314},
    {657, 1315, 1316},
    {658, 1317, 1318},
    {659, 1319, 1320},
    {660, 1321, 1322},
    {661, 1323, 1324},
    {662, 1325, 1326},
    {663, 1327, 1328},
    {664, 1329, 1330},
    {665, 1331, 1332},
    {666, 1333, 1334},
    {667, 1335, 1336},
    {668, 1337, 1338},
    {669, 1339, 1340},
    {670, 1341, 1342},
    {671, 1343, 1344},
    {672, 1345, 1346},
    {673, 1347, 1348},
    {674, 1349, 1350},
    {675, 1351, 1352},
    {676, 1353, 1354},
    {677, 1355, 1356},
    {678, 1357, 1358},
    {679, 1359, 1360},
    {680, 1361, 1362},
    {681, 1363, 1364},
    {682, 1365, 1366},
    {683, 1367, 1368},
    {684, 1369, 1370},
    {685, 1371, 1372},
    {686, 1373, 1374},
    {687, 1375, 1376},
    {688, 1377, 1378},
    {689, 1379, 1380},
    {690, 1381, 1382},
    {691, 1383, 1384},
    {692, 1385, 1386},
    {693, 1387, 1388},
    {694, 1389, 1390},
    {695, 1391, 1392},
    {696, 1393, 1394},
    {697, 1395, 1396},
    {698, 1397, 1398},
    {699, 1399, 1400},
    {700, 1401, 1402},
    {701, 1403, 1404},
    {702, 1405, 1406},
    {703, 1407, 1408},
    {704, 1409, 1410}, // ########################################
    {705, 1411, 1412},
    {706, 1413, 1414},
    {707, 1415, 1416},
    {708, 1417, 1418},
    {709, 1419, 1420},
    {710, 1421, 1422},
    {711, 1423, 1424},
    {712, 1425, 1426},
    {713, 1427, 1428},
    {714, 1429, 1430},
    {715, 1431, 1432},
    {716, 1433, 1434},
    {717, 1435, 1436},
    {718, 1437, 1438},
    {719, 1439, 1440},
    {720, 1441, 1442},
    {721, 1443, 1444},
    {722, 1445, 1446},
    {723, 1447, 1448},
    {724, 1449, 1450},
    {725, 1451, 1452},
    {726, 1453, 1454},
    {727, 1455, 1456},
    {728, 1457, 1458},
    {729, 1459, 1460},
    {730, 1461, 1462},
    {731, 1463, 1464},
    {732, 1465, 1466},
    {733, 1467, 1468},
    {734, 1469, 1470},
    {735, 1471, 1472},
    {736, 1473, 1474},
    {737, 1475, 1476},
    {738, 1477, 1478},
    {739, 1479, 1480},
    {740, 1481, 1482},
    {741, 1483, 1484},
    {742, 1485, 1486},
    {743, 1487, 1488},
    {744, 1489, 1490},
    {745, 1491, 1492},
    {746, 1493, 1494},
    {747, 1495, 1496},
    {748, 1497, 1498},
    {749, 1499, 1500},
    {750, 1501, 1502},
    {751, 1503, 1504},
    {752, 1505, 1506},
    {753, 1507, 1508},
    {754, 1509, 1510},
    {755, 1511, 1512},
    {756, 1513, 1514},
    {757, 1515, 1516},
    {758, 1517, 1518},
    {759, 1519, 1520},
    {760, 1521, 1522},
    {761, 1523, 1524},
    {762, 1525, 1526},
    {763, 1527, 1528},
    {764, 1529, 1530},
    {765, 1531, 1532},
    {766, 1533, 1534},
    {767, 1535, 1536},
    {768, 1537, 1538}, // ########################################
    {769, 1539, 1540},
    {770, 1541, 1542},
    {771, 1543, 1544},
    {772, 1545, 1546},
    {773, 1547, 1548},
    {774, 1549, 1550},
    {775, 1551, 1552},
    {776, 1553, 1554},
    {777, 1555, 1556},
    {778, 1557, 1558},
    {779, 1559, 1560},
    {780, 1561, 1562},
    {781, 1563, 1564},
    {782, 1565, 1566},
    {783, 1567, 1568},
    {784, 1569, 1570},
    {785, 1571, 1572},
    {786, 1573, 1574},
    {787, 1575, 1576},
    {788, 1577, 1578},
    {789, 1579, 1580},
    {790, 1581, 1582},
    {791, 1583, 1584},
    {792, 1585, 1586},
    {793, 1587, 1588},
    {794, 1589, 1590},
    {795, 1591, 1592},
    {796, 1593, 1594},
    {797, 1595, 1596},
    {798, 1597, 1598},
    {799, 1599, 1600},
    {800, 1601, 1602},
    {801, 1603, 1604},
    {802, 1605, 1606},
    {803, 1607, 1608},
    {804, 1609, 1610},
    {805, 1611, 1612},
    {806, 1613, 1614},
    {807, 1615, 1616},
    {808, 1617, 1618},
    {809, 1619, 1620},
    {810, 1621, 1622},
    {811, 1623, 1624},
    {812, 1625, 1626},
    {813, 1627, 1628},
    {814, 1629, 1630},
    {815, 1631, 1632},
    {816, 1633, 1634},
    {817, 1635, 1636},
    {818, 1637, 1638},
    {819, 1639, 1640},
    {820, 1641, 1642},
    {821, 1643, 1644},
    {822, 1645, 1646},
    {823, 1647, 1648},
    {824, 1649, 1650},
    {825, 1651, 1652},
    {826, 1653, 1654},
    {827, 1655, 1656},
    {828, 1657, 1658},
    {829, 1659, 1660},
    {830, 1661, 1662},
    {831, 1663, 1664},
    {832, 1665, 1666}, // ########################################
    {833, 1667, 1668},
    {834, 1669, 1670},
    {835, 1671, 1672},
    {836, 1673, 1674},
    {837, 1675, 1676},
    {838, 1677, 1678},
    {839, 1679, 1680},
    {840, 1681, 1682},
    {841, 1683, 1684},
    {842, 1685, 1686},
    {843, 1687, 1688},
    {844, 1689, 1690},
    {845, 1691, 1692},
    {846, 1693, 1694},
    {847, 1695, 1696},
    {848, 1697, 1698},
    {849, 1699, 1700},
    {850, 1701, 1702},
    {851, 1703, 1704},
    {852, 1705, 1706},
    {853, 1707, 1708},
    {854, 1709, 1710},
    {855, 1711, 1712},
    {856, 1713, 1714},
    {857, 1715, 1716},
    {858, 1717, 1718},
    {859, 1719, 1720},
    {860, 1721, 1722},
    {861, 1723, 1724},
    {862, 1725, 1726},
    {863, 1727, 1728},
    {864, 1729, 1730},
    {865, 1731, 1732},
    {866, 1733, 1734},
    {867, 1735, 1736},
    {868, 1737, 1738},
    {869, 1739, 1740},
    {870, 1741, 1742},
    {871, 1743, 1744},
    {872, 1745, 1746},
    {873, 1747, 1748},
    {874, 1749, 1750},
    {875, 1751, 1752},
    {876, 1753, 1754},
    {877, 1755, 1756},
    {878, 1757, 1758},
    {879, 1759, 1760},
    {880, 1761, 1762},
    {881, 1763, 1764},
    {882, 1765, 1766},
    {883, 1767, 1768},
    {884, 1769, 1770},
    {885, 1771, 1772},
    {886, 1773, 1774},
    {887, 1775, 1776},
    {888, 1777, 1778},
    {889, 1779, 1780},
    {890, 1781, 1782},
    {891, 1783, 1784},
    {892, 1785, 1786},
    {893, 1787, 1788},
    {894, 1789, 1790},
    {895, 1791, 1792},
    {896, 1793, 1794}, // ########################################
    {897, 1795, 1796},
    {898, 1797, 1798},
    {899, 1799, 1800},
    {900, 1801, 1802},
    {901, 1803, 1804},
    {902, 1805, 1806},
    {903, 1807, 1808},
    {904, 1809, 1810},
    {905, 1811, 1812},
    {906, 1813, 1814},
    {907, 1815, 1816},
    {908, 1817, 1818},
    {909, 1819, 1820},
    {910, 1821, 1822},
    {911, 1823, 1824},
    {912, 1825, 1826},
    {913, 1827, 1828},
    {914, 1829, 1830},
    {915, 1831, 1832},
    {916, 1833, 1834},
    {917, 1835, 1836},
    {918, 1837, 1838},
    {919, 1839, 1840},
    {920, 1841, 1842},
    {921, 1843, 1844},
    {922, 1845, 1846},
    {923, 1847, 1848},
    {924, 1849, 1850},
    {925, 1851, 1852},
    {926, 1853, 1854},
    {927, 1855, 1856},
    {928, 1857, 1858},
    {929, 1859, 1860},
    {930, 1861, 1862},
    {931, 1863, 1864},
    {932, 1865, 1866},
    {933, 1867, 1868},
    {934, 1869, 1870},
    {935, 1871, 1872},
    {936, 1873, 1874},
    {937, 1875, 1876},
    {938, 1877, 1878},
    {939, 1879, 1880},
    {940, 1881, 1882},
    {941, 1883, 1884},
    {942, 1885, 1886},
    {943, 1887, 1888},
    {944, 1889, 1890},
    {945, 1891, 1892},
    {946, 1893, 1894},
    {947, 1895, 1896},
    {948, 1897, 1898},
    {949, 1899, 1900},
    {950, 1901, 1902},
    {951, 1903, 1904},
    {952, 1905, 1906},
    {953, 1907, 1908},
    {954, 1909, 1910},
    {955, 1911, 1912},
    {956, 1913, 1914},
    {957, 1915, 1916},
    {958, 1917, 1918},
    {959, 1919, 1920},
    {960, 1921, 1922}, // ########################################
    {961, 1923, 1924},
    {962, 1925, 1926},
    {963, 1927, 1928},
    {964, 1929, 1930},
    {965, 1931, 1932},
    {966, 1933, 1934},
    {967, 1935, 1936},
    {968, 1937, 1938},
    {969, 1939, 1940},
    {970, 1941, 1942},
    {971, 1943, 1944},
    {972, 1945, 1946},
    {973, 1947, 1948},
    {974, 1949, 1950},
    {975, 1951, 1952},
    {976, 1953, 1954},
    {977, 1955, 1956},
    {978, 1957, 1958},
    {979, 1959, 1960},
    {980, 1961, 1962},
    {981, 1963, 1964},
    {982, 1965, 1966},
    {983, 1967, 1968},
    {984, 1969, 1970},
    {985, 1971, 1972},
    {986, 1973, 1974},
    {987, 1975, 1976},
    {988, 1977, 1978},
    {989, 1979, 1980},
    {990, 1981, 1982},
    {991, 1983, 1984},
    {992, 1985, 1986},
    {993, 1987, 1988},
    {994, 1989, 1990},
    {995, 1991, 1992},
    {996, 1993, 1994},
    {997, 1995, 1996},
    {998, 1997, 1998},
    {999, 1999, 2000},
    {1000, 2001, 2002},
    {1001, 2003, 2004},
    {1002, 2005, 2006},
    {1003, 2007, 2008},
    {1004, 2009, 2010},
    {1005, 2011, 2012},
    {1006, 2013, 2014},
    {1007, 2015, 2016},
    {1008, 2017, 2018},
    {1009, 2019, 2020},
    {1010, 2021, 2022},
    {1011, 2023, 2024},
    {1012, 2025, 2026},
    {1013, 2027, 2028},
    {1014, 2029, 2030},
    {1015, 2031, 2032},
    {1016, 2033, 2034},
    {1017, 2035, 2036},
    {1018, 2037, 2038},
    {1019, 2039, 2040},
    {1020, 2041, 2042},
    {1021, 2043, 2044},
    {1022, 2045, 2046},
    {1023, 2047, 2048},
    {1024, 2049, 2050}, // ########################################
    {1025, 2051, 2052},
    {1026, 2053, 2054},
    {1027, 2055, 2056},
    {1028, 2057, 2058},
    {1029, 2059, 2060},
    {1030, 2061, 2062},
    {1031, 2063, 2064},
    {1032, 2065, 2066},
    {1033, 2067, 2068},
    {1034, 2069, 2070},
    {1035, 2071, 2072},
    {1036, 2073, 2074},
    {1037, 2075, 2076},
    {1038, 2077, 2078},
    {1039, 2079, 2080},
    {1040, 2081, 2082},
    {1041, 2083, 2084},
    {1042, 2085, 2086},
    {1043, 2087, 2088},
    {1044, 2089, 2090},
    {1045, 2091, 2092},
    {1046, 2093, 2094},
    {1047, 2095, 2096},
    {1048, 2097, 2098},
    {1049, 2099, 2100},
    {1050, 2101, 2102},
    {1051, 2103, 2104},
    {1052, 2105, 2106},
    {1053, 2107, 2108},
    {1054, 2109, 2110},
    {1055, 2111, 2112},
    {1056, 2113, 2114},
    {1057, 2115, 2116},
    {1058, 2117, 2118},
    {1059, 2119, 2120},
    {1060, 2121, 2122},
    {1061, 2123, 2124},
    {1062, 2125, 2126},
    {1063, 2127, 2128},
    {1064, 2129, 2130},
    {1065, 2131, 2132},
    {1066, 2133, 2134},
    {1067, 2135, 2136},
    {1068, 2137, 2138},
    {1069, 2139, 2140},
    {1070, 2141, 2142},
    {1071, 2143, 2144},
    {1072, 2145, 2146},
    {1073, 2147, 2148},
    {1074, 2149, 2150},
    {1075, 2151, 2152},
    {1076, 2153, 2154},
    {1077, 2155, 2156},
    {1078, 2157, 2158},
    {1079, 2159, 2160},
    {1080, 2161, 2162},
    {1081, 2163, 2164},
    {1082, 2165, 2166},
    {1083, 2167, 2168},
    {1084, 2169, 2170},
    {1085, 2171, 2172},
    {1086, 2173, 2174},
    {1087, 2175, 2176},
    {1088, 2177, 2178}, // ########################################
    {1089, 2179, 2180},
    {1090, 2181, 2182},
    {1091, 2183, 2184},
    {1092, 2185, 2186},
    {1093, 2187, 2188},
    {1094, 2189, 2190},
    {1095, 2191, 2192},
    {1096, 2193, 2194},
    {1097, 2195, 2196},
    {1098, 2197, 2198},
    {1099, 2199, 2200},
    {1100, 2201, 2202},
    {1101, 2203, 2204},
    {1102, 2205, 2206},
    {1103, 2207, 2208},
    {1104, 2209, 2210},
    {1105, 2211, 2212},
    {1106, 2213, 2214},
    {1107, 2215, 2216},
    {1108, 2217, 2218},
    {1109, 2219, 2220},
    {1110, 2221, 2222},
    {1111, 2223, 2224},
    {1112, 2225, 2226},
    {1113, 2227, 2228},
    {1114, 2229, 2230},
    {1115, 2231, 2232},
    {1116, 2233, 2234},
    {1117, 2235, 2236},
    {1118, 2237, 2238},
    {1119, 2239, 2240},
    {1120, 2241, 2242},
    {1121, 2243, 2244},
    {1122, 2245, 2246},
    {1123, 2247, 2248},
    {1124, 2249, 2250},
    {1125, 2251, 2252},
    {1126, 2253, 2254},
    {1127, 2255, 2256},
    {1128, 2257, 2258},
    {1129, 2259, 2260},
    {1130, 2261, 2262},
    {1131, 2263, 2264},
    {1132, 2265, 2266},
    {1133, 2267, 2268},
    {1134, 2269, 2270},
    {1135, 2271, 2272},
    {1136, 2273, 2274},
    {1137, 2275, 2276},
    {1138, 2277, 2278},
    {1139, 2279, 2280},
    {1140, 2281, 2282},
    {1141, 2283, 2284},
    {1142, 2285, 2286},
    {1143, 2287, 2288},
    {1144, 2289, 2290},
    {1145, 2291, 2292},
    {1146, 2293, 2294},
    {1147, 2295, 2296},
    {1148, 2297, 2298},
    {1149, 2299, 2300},
    {1150, 2301, 2302},
    {1151, 2303, 2304},
    {1152, 2305, 2306}, // ########################################
    {1153, 2307, 2308},
    {1154, 2309, 2310},
    {1155, 2311, 2312},
    {1156, 2313, 2314},
    {1157, 2315, 2316},
    {1158, 2317, 2318},
    {1159, 2319, 2320},
    {1160, 2321, 2322},
    {1161, 2323, 2324},
    {1162, 2325, 2326},
    {1163, 2327, 2328},
    {1164, 2329, 2330},
    {1165, 2331, 2332},
    {1166, 2333, 2334},
    {1167, 2335, 2336},
    {1168, 2337, 2338},
    {1169, 2339, 2340},
    {1170, 2341, 2342},
    {1171, 2343, 2344},
    {1172, 2345, 2346},
    {1173, 2347, 2348},
    {1174, 2349, 2350},
    {1175, 2351, 2352},
    {1176, 2353, 2354},
    {1177, 2355, 2356},
    {1178, 2357, 2358},
    {1179, 2359, 2360},
    {1180, 2361, 2362},
    {1181, 2363, 2364},
    {1182, 2365, 2366},
    {1183, 2367, 2368},
    {1184, 2369, 2370},
    {1185, 2371, 2372},
    {1186, 2373, 2374},
    {1187, 2375, 2376},
    {1188, 2377, 2378},
    {1189, 2379, 2380},
    {1190, 2381, 2382},
    {1191, 2383, 2384},
    {1192, 2385, 2386},
    {1193, 2387, 2388},
    {1194, 2389, 2390},
    {1195, 2391, 2392},
    {1196, 2393, 2394},
    {1197, 2395, 2396},
    {1198, 2397, 2398},
    {1199, 2399, 2400},
    {1200, 2401, 2402},
    {1201, 2403, 2404},
    {1202, 2405, 2406},
    {1203, 2407, 2408},
    {1204, 2409, 2410},
    {1205, 2411, 2412},
    {1206, 2413, 2414},
    {1207, 2415, 2416},
    {1208, 2417, 2418},
    {1209, 2419, 2420},
    {1210, 2421, 2422},
    {1211, 2423, 2424},
    {1212, 2425, 2426},
    {1213, 2427, 2428},
    {1214, 2429, 2430},
    {1215, 2431, 2432},
    {1216, 2433, 2434}, // ########################################
    {1217, 2435, 2436},
    {1218, 2437, 2438},
    {1219, 2439, 2440},
    {1220, 2441, 2442},
    {1221, 2443, 2444},
    {1222, 2445, 2446},
    {1223, 2447, 2448},
    {1224, 2449, 2450},
    {1225, 2451, 2452},
    {1226, 2453, 2454},
    {1227, 2455, 2456},
    {1228, 2457, 2458},
    {1229, 2459, 2460},
    {1230, 2461, 2462},
    {1231, 2463, 2464},
    {1232, 2465, 2466},
    {1233, 2467, 2468},
    {1234, 2469, 2470},
    {1235, 2471, 2472},
    {1236, 2473, 2474},
    {1237, 2475, 2476},
    {1238, 2477, 2478},
    {1239, 2479, 2480},
    {1240, 2481, 2482},
    {1241, 2483, 2484},
    {1242, 2485, 2486},
    {1243, 2487, 2488},
    {1244, 2489, 2490},
    {1245, 2491, 2492},
    {1246, 2493, 2494},
    {1247, 2495, 2496},
    {1248, 2497, 2498},
    {1249, 2499, 2500},
    {1250, 2501, 2502},
    {1251, 2503, 2504},
    {1252, 2505, 2506},
    {1253, 2507, 2508},
    {1254, 2509, 2510},
    {1255, 2511, 2512},
    {1256, 2513, 2514},
    {1257, 2515, 2516},
    {1258, 2517, 2518},
    {1259, 2519, 2520},
    {1260, 2521, 2522},
    {1261, 2523, 2524},
    {1262, 2525, 2526},
    {1263, 2527, 2528},
    {1264, 2529, 2530},
    {1265, 2531, 2532},
    {1266, 2533, 2534},
    {1267, 2535, 2536},
    {1268, 2537, 2538},
    {1269, 2539, 2540},
    {1270, 2541, 2542},
    {1271, 2543, 2544},
    {1272, 2545, 2546},
    {1273, 2547, 2548},
    {1274, 2549, 2550},
    {1275, 2551, 2552},
    {1276, 2553, 2554},
    {1277, 2555, 2556},
    {1278, 2557, 2558},
    {1279, 2559, 2560},
    {1280, 2561, 2562}, // ########################################
    {1281, 2563, 2564},
    {1282, 2565, 2566},
    {1283, 2567, 2568},
    {1284, 2569, 2570},
    {1285, 2571, 2572},
    {1286, 2573, 2574},
    {1287, 2575, 2576},
    {1288, 2577, 2578},
    {1289, 2579, 2580},
    {1290, 2581, 2582},
    {1291, 2583, 2584},
    {1292, 2585, 2586},
    {1293, 2587, 2588},
    {1294, 2589, 2590},
    {1295, 2591, 2592},
    {1296, 2593, 2594},
    {1297, 2595, 2596},
    {1298, 2597, 2598},
    {1299, 2599, 2600},
    {1300, 2601, 2602},
    {1301, 2603, 2604},
    {1302, 2605, 2606},
    {1303, 2607, 2608},
    {1304, 2609, 2610},
    {1305, 2611, 2612},
    {1306, 2613, 2614},
    {1307, 2615, 2616},
    {1308, 2617, 2618},
    {1309, 2619, 2620},
    {1310, 2621, 2622},
    {1311, 2623, 2624},
    {1312, 2625, 2626},
    {1313, 2627, 2628},
    {1314, 2629, 2630},
    {1315, 2631, 2632},
    {1316, 2633, 2634},
    {1317, 2635, 2636},
    {1318, 2637, 2638},
    {1319, 2639, 2640},
    {1320, 2641, 2642},
    {1321, 2643, 2644},
    {1322, 2645, 2646},
    {1323, 2647, 2648},
    {1324, 2649, 2650},
    {1325, 2651, 2652},
    {1326, 2653, 2654},
    {1327, 2655, 2656},
    {1328, 2657, 2658},
    {1329, 2659, 2660},
    {1330, 2661, 2662},
    {1331, 2663, 2664},
    {1332, 2665, 2666},
    {1333, 2667, 2668},
    {1334, 2669, 2670},
    {1335, 2671, 2672},
    {1336, 2673, 2674},
    {1337, 2675, 2676},
    {1338, 2677, 2678},
    {1339, 2679, 2680},
    {1340, 2681, 2682},
    {1341, 2683, 2684},
    {1342, 2685, 2686},
    {1343, 2687, 2688},
    {1344, 2689, 2690}, // ########################################
    {1345, 2691, 2692},
    {1346, 2693, 2694},
    {1347, 2695, 2696},
    {1348, 2697, 2698},
    {1349, 2699, 2700},
    {1350, 2701, 2702},
    {1351, 2703, 2704},
    {1352, 2705, 2706},
    {1353, 2707, 2708},
    {1354, 2709, 2710},
    {1355, 2711, 2712},
    {1356, 2713, 2714},
    {1357, 2715, 2716},
    {1358, 2717, 2718},
    {1359, 2719, 2720},
    {1360, 2721, 2722},
    {1361, 2723, 2724},
    {1362, 2725, 2726},
    {1363, 2727, 2728},
    {1364, 2729, 2730},
    {1365, 2731, 2732},
    {1366, 2733, 2734},
    {1367, 2735, 2736},
    {1368, 2737, 2738},
    {1369, 2739, 2740},
    {1370, 2741, 2742},
    {1371, 2743, 2744},
    {1372, 2745, 2746},
    {1373, 2747, 2748},
    {1374, 2749, 2750},
    {1375, 2751, 2752},
    {1376, 2753, 2754},
    {1377, 2755, 2756},
    {1378, 2757, 2758},
    {1379, 2759, 2760},
    {1380, 2761, 2762},
    {1381, 2763, 2764},
    {1382, 2765, 2766},
    {1383, 2767, 2768},
    {1384, 2769, 2770},
    {1385, 2771, 2772},
    {1386, 2773, 2774},
    {1387, 2775, 2776},
    {1388, 2777, 2778},
    {1389, 2779, 2780},
    {1390, 2781, 2782},
    {1391, 2783, 2784},
    {1392, 2785, 2786},
    {1393, 2787, 2788},
    {1394, 2789, 2790},
    {1395, 2791, 2792},
    {1396, 2793, 2794},
    {1397, 2795, 2796},
    {1398, 2797, 2798},
    {1399, 2799, 2800},
    {1400, 2801, 2802},
    {1401, 2803, 2804},
    {1402, 2805, 2806},
    {1403, 2807, 2808},
    {1404, 2809, 2810},
    {1405, 2811, 2812},
    {1406, 2813, 2814},
    {1407, 2815, 2816},
    {1408, 2817, 2818}, // ########################################
    {1409, 2819, 2820},
    {1410, 2821, 2822},
    {1411, 2823, 2824},
    {1412, 2825, 2826},
    {1413, 2827, 2828},
    {1414, 2829, 2830},
    {1415, 2831, 2832},
    {1416, 2833, 2834},
    {1417, 2835, 2836},
    {1418, 2837, 2838},
    {1419, 2839, 2840},
    {1420, 2841, 2842},
    {1421, 2843, 2844},
    {1422, 2845, 2846},
    {1423, 2847, 2848},
    {1424, 2849, 2850},
    {1425, 2851, 2852},
    {1426, 2853, 2854},
    {1427, 2855, 2856},
    {1428, 2857, 2858},
    {1429, 2859, 2860},
    {1430, 2861, 2862},
    {1431, 2863, 2864},
    {1432, 2865, 2866},
    {1433, 2867, 2868},
    {1434, 2869, 2870},
    {1435, 2871, 2872},
    {1436, 2873, 2874},
    {1437, 2875, 2876},
    {1438, 2877, 2878},
    {1439, 2879, 2880},
    {1440, 2881, 2882},
    {1441, 2883, 2884},
    {1442, 2885, 2886},
    {1443, 2887, 2888},
    {1444, 2889, 2890},
    {1445, 2891, 2892},
    {1446, 2893, 2894},
    {1447, 2895, 2896},
    {1448, 2897, 2898},
    {1449, 2899, 2900},
    {1450, 2901, 2902},
    {1451, 2903, 2904},
    {1452, 2905, 2906},
    {1453, 2907, 2908},
    {1454, 2909, 2910},
    {1455, 2911, 2912},
    {1456, 2913, 2914},
    {1457, 2915, 2916},
    {1458, 2917, 2918},
    {1459, 2919, 2920},
    {1460, 2921, 2922},
    {1461, 2923, 2924},
    {1462, 2925, 2926},
    {1463, 2927, 2928},
    {1464, 2929, 2930},
    {1465, 2931, 2932},
    {1466, 2933, 2934},
    {1467, 2935, 2936},
    {1468, 2937, 2938},
    {1469, 2939, 2940},
    {1470, 2941, 2942},
    {1471, 2943, 2944},
    {1472, 2945, 2946}, // ########################################
    {1473, 2947, 2948},
    {1474, 2949, 2950},
    {1475, 2951, 2952},
    {1476, 2953, 2954},
    {1477, 2955, 2956},
    {1478, 2957, 2958},
    {1479, 2959, 2960},
    {1480, 2961, 2962},
    {1481, 2963, 2964},
    {1482, 2965, 2966},
    {1483, 2967, 2968},
    {1484, 2969, 2970},
    {1485, 2971, 2972},
    {1486, 2973, 2974},
    {1487, 2975, 2976},
    {1488, 2977, 2978},
    {1489, 2979, 2980},
    {1490, 2981, 2982},
    {1491, 2983, 2984},
    {1492, 2985, 2986},
    {1493, 2987, 2988},
    {1494, 2989, 2990},
    {1495, 2991, 2992},
    {1496, 2993, 2994},
    {1497, 2995, 2996},
    {1498, 2997, 2998},
    {1499, 2999, 3000},
    {1500, 3001, 3002},
    {1501, 3003, 3004},
    {1502, 3005, 3006},
    {1503, 3007, 3008},
    {1504, 3009, 3010},
    {1505, 3011, 3012},
    {1506, 3013, 3014},
    {1507, 3015, 3016},
    {1508, 3017, 3018},
    {1509, 3019, 3020},
    {1510, 3021, 3022},
    {1511, 3023, 3024},
    {1512, 3025, 3026},
    {1513, 3027, 3028},
    {1514, 3029, 3030},
    {1515, 3031, 3032},
    {1516, 3033, 3034},
    {1517, 3035, 3036},
    {1518, 3037, 3038},
    {1519, 3039, 3040},
    {1520, 3041, 3042},
    {1521, 3043, 3044},
    {1522, 3045, 3046},
    {1523, 3047, 3048},
    {1524, 3049, 3050},
    {1525, 3051, 3052},
    {1526, 3053, 3054},
    {1527, 3055, 3056},
    {1528, 3057, 3058},
    {1529, 3059, 3060},
    {1530, 3061, 3062},
    {1531, 3063, 3064},
    {1532, 3065, 3066},
    {1533, 3067, 3068},
    {1534, 3069, 3070},
    {1535, 3071, 3072},
    {1536, 3073, 3074}, // ########################################
    {1537, 3075, 3076},
    {1538, 3077, 3078},
    {1539, 3079, 3080},
    {1540, 3081, 3082},
    {1541, 3083, 3084},
    {1542, 3085, 3086},
    {1543, 3087, 3088},
    {1544, 3089, 3090},
    {1545, 3091, 3092},
    {1546, 3093, 3094},
    {1547, 3095, 3096},
    {1548, 3097, 3098},
    {1549, 3099, 3100},
    {1550, 3101, 3102},
    {1551, 3103, 3104},
    {1552, 3105, 3106},
    {1553, 3107, 3108},
    {1554, 3109, 3110},
    {1555, 3111, 3112},
    {1556, 3113, 3114},
    {1557, 3115, 3116},
    {1558, 3117, 3118},
    {1559, 3119, 3120},
    {1560, 3121, 3122},
    {1561, 3123, 3124},
    {1562, 3125, 3126},
    {1563, 3127, 3128},
    {1564, 3129, 3130},
    {1565, 3131, 3132},
    {1566, 3133, 3134},
    {1567, 3135, 3136},
    {1568, 3137, 3138},
    {1569, 3139, 3140},
    {1570, 3141, 3142},
    {1571, 3143, 3144},
    {1572, 3145, 3146},
    {1573, 3147, 3148},
    {1574, 3149, 3150},
    {1575, 3151, 3152},
    {1576, 3153, 3154},
    {1577, 3155, 3156},
    {1578, 3157, 3158},
    {1579, 3159, 3160},
    {1580, 3161, 3162},
    {1581, 3163, 3164},
    {1582, 3165, 3166},
    {1583, 3167, 3168},
    {1584, 3169, 3170},
    {1585, 3171, 3172},
    {1586, 3173, 3174},
    {1587, 3175, 3176},
    {1588, 3177, 3178},
    {1589, 3179, 3180},
    {1590, 3181, 3182},
    {1591, 3183, 3184},
    {1592, 3185, 3186},
    {1593, 3187, 3188},
    {1594, 3189, 3190},
    {1595, 3191, 3192},
    {1596, 3193, 3194},
    {1597, 3195, 3196},
    {1598, 3197, 3198},
    {1599, 3199, 3200},
    {1600, 3201, 3202}, // ########################################
    {1601, 3203, 3204},
    {1602, 3205, 3206},
    {1603, 3207, 3208},
    {1604, 3209, 3210},
    {1605, 3211, 3212},
    {1606, 3213, 3214},
    {1607, 3215, 3216},
    {1608, 3217, 3218},
    {1609, 3219, 3220},
    {1610, 3221, 3222},
    {1611, 3223, 3224},
    {1612, 3225, 3226},
    {1613, 3227, 3228},
    {1614, 3229, 3230},
    {1615, 3231, 3232},
    {1616, 3233, 3234},
    {1617, 3235, 3236},
    {1618, 3237, 3238},
    {1619, 3239, 3240},
    {1620, 3241, 3242},
    {1621, 3243, 3244},
    {1622, 3245, 3246},
    {1623, 3247, 3248},
    {1624, 3249, 3250},
    {1625, 3251, 3252},
    {1626, 3253, 3254},
    {1627, 3255, 3256},
    {1628, 3257, 3258},
    {1629, 3259, 3260},
    {1630, 3261, 3262},
    {1631, 3263, 3264},
    {1632, 3265, 3266},
    {1633, 3267, 3268},
    {1634, 3269, 3270},
    {1635, 3271, 3272},
    {1636, 3273, 3274},
    {1637, 3275, 3276},
    {1638, 3277, 3278},
    {1639, 3279, 3280},
    {1640, 3281, 3282},
    {1641, 3283, 3284},
    {1642, 3285, 3286},
    {1643, 3287, 3288},
    {1644, 3289, 3290},
    {1645, 3291, 3292},
    {1646, 3293, 3294},
    {1647, 3295, 3296},
    {1648, 3297, 3298},
    {1649, 3299, 3300},
    {1650, 3301, 3302},
    {1651, 3303, 3304},
    {1652, 3305, 3306},
    {1653, 3307, 3308},
    {1654, 3309, 3310},
    {1655, 3311, 3312},
    {1656, 3313, 3314},
    {1657, 3315, 3316},
    {1658, 3317, 3318},
    {1659, 3319, 3320},
    {1660, 3321, 3322},
    {1661, 3323, 3324},
    {1662, 3325, 3326},
    {1663, 3327, 3328},
    {1664, 3329, 3330}, // ########################################
    {1665, 3331, 3332},
    {1666, 3333, 3334},
    {1667, 3335, 3336},
    {1668, 3337, 3338},
    {1669, 3339, 3340},
    {1670, 3341, 3342},
    {1671, 3343, 3344},
    {1672, 3345, 3346},
    {1673, 3347, 3348},
    {1674, 3349, 3350},
    {1675, 3351, 3352},
    {1676, 3353, 3354},
    {1677, 3355, 3356},
    {1678, 3357, 3358},
    {1679, 3359, 3360},
    {1680, 3361, 3362},
    {1681, 3363, 3364},
    {1682, 3365, 3366},
    {1683, 3367, 3368},
    {1684, 3369, 3370},
    {1685, 3371, 3372},
    {1686, 3373, 3374},
    {1687, 3375, 3376},
    {1688, 3377, 3378},
    {1689, 3379, 3380},
    {1690, 3381, 3382},
    {1691, 3383, 3384},
    {1692, 3385, 3386},
    {1693, 3387, 3388},
    {1694, 3389, 3390},
    {1695, 3391, 3392},
    {1696, 3393, 3394},
    {1697, 3395, 3396},
    {1698, 3397, 3398},
    {1699, 3399, 3400},
    {1700, 3401, 3402},
    {1701, 3403, 3404},
    {1702, 3405, 3406},
    {1703, 3407, 3408},
    {1704, 3409, 3410},
    {1705, 3411, 3412},
    {1706, 3413, 3414},
    {1707, 3415, 3416},
    {1708, 3417, 3418},
    {1709, 3419, 3420},
    {1710, 3421, 3422},
    {1711, 3423, 3424},
    {1712, 3425, 3426},
    {1713, 3427, 3428},
    {1714, 3429, 3430},
    {1715, 3431, 3432},
    {1716, 3433, 3434},
    {1717, 3435, 3436},
    {1718, 3437, 3438},
    {1719, 3439, 3440},
    {1720, 3441, 3442},
    {1721, 3443, 3444},
    {1722, 3445, 3446},
    {1723, 3447, 3448},
    {1724, 3449, 3450},
    {1725, 3451, 3452},
    {1726, 3453, 3454},
    {1727, 3455, 3456},
    {1728, 3457, 3458}, // ########################################
    {1729, 3459, 3460},
    {1730, 3461, 3462},
    {1731, 3463, 3464},
    {1732, 3465, 3466},
    {1733, 3467, 3468},
    {1734, 3469, 3470},
    {1735, 3471, 3472},
    {1736, 3473, 3474},
    {1737, 3475, 3476},
    {1738, 3477, 3478},
    {1739, 3479, 3480},
    {1740, 3481, 3482},
    {1741, 3483, 3484},
    {1742, 3485, 3486},
    {1743, 3487, 3488},
    {1744, 3489, 3490},
    {1745, 3491, 3492},
    {1746, 3493, 3494},
    {1747, 3495, 3496},
    {1748, 3497, 3498},
    {1749, 3499, 3500},
    {1750, 3501, 3502},
    {1751, 3503, 3504},
    {1752, 3505, 3506},
    {1753, 3507, 3508},
    {1754, 3509, 3510},
    {1755, 3511, 3512},
    {1756, 3513, 3514},
    {1757, 3515, 3516},
    {1758, 3517, 3518},
    {1759, 3519, 3520},
    {1760, 3521, 3522},
    {1761, 3523, 3524},
    {1762, 3525, 3526},
    {1763, 3527, 3528},
    {1764, 3529, 3530},
    {1765, 3531, 3532},
    {1766, 3533, 3534},
    {1767, 3535, 3536},
    {1768, 3537, 3538},
    {1769, 3539, 3540},
    {1770, 3541, 3542},
    {1771, 3543, 3544},
    {1772, 3545, 3546},
    {1773, 3547, 3548},
    {1774, 3549, 3550},
    {1775, 3551, 3552},
    {1776, 3553, 3554},
    {1777, 3555, 3556},
    {1778, 3557, 3558},
    {1779, 3559, 3560},
    {1780, 3561, 3562},
    {1781, 3563, 3564},
    {1782, 3565, 3566},
    {1783, 3567, 3568},
    {1784, 3569, 3570},
    {1785, 3571, 3572},
    {1786, 3573, 3574},
    {1787, 3575, 3576},
    {1788, 3577, 3578},
    {1789, 3579, 3580},
    {1790, 3581, 3582},
    {1791, 3583, 3584},
    {1792, 3585, 3586}, // ########################################
    {1793, 3587, 3588},
    {1794, 3589, 3590},
    {1795, 3591, 3592},
    {1796, 3593, 3594},
    {1797, 3595, 3596},
    {1798, 3597, 3598},
    {1799, 3599, 3600},
    {1800, 3601, 3602},
    {1801, 3603, 3604},
    {1802, 3605, 3606},
    {1803, 3607, 3608},
    {1804, 3609, 3610},
    {1805, 3611, 3612},
    {1806, 3613, 3614},
    {1807, 3615, 3616},
    {1808, 3617, 3618},
    {1809, 3619, 3620},
    {1810, 3621, 3622},
    {1811, 3623, 3624},
    {1812, 3625, 3626},
    {1813, 3627, 3628},
    {1814, 3629, 3630},
    {1815, 3631, 3632},
    {1816, 3633, 3634},
    {1817, 3635, 3636},
    {1818, 3637, 3638},
    {1819, 3639, 3640},
    {1820, 3641, 3642},
    {1821, 3643, 3644},
    {1822, 3645, 3646},
    {1823, 3647, 3648},
    {1824, 3649, 3650},
    {1825, 3651, 3652},
    {1826, 3653, 3654},
    {1827, 3655, 3656},
    {1828, 3657, 3658},
    {1829, 3659, 3660},
    {1830, 3661, 3662},
    {1831, 3663, 3664},
    {1832, 3665, 3666},
    {1833, 3667, 3668},
    {1834, 3669, 3670},
    {1835, 3671, 3672},
    {1836, 3673, 3674},
    {1837, 3675, 3676},
    {1838, 3677, 3678},
    {1839, 3679, 3680},
    {1840, 3681, 3682},
    {1841, 3683, 3684},
    {1842, 3685, 3686},
    {1843, 3687, 3688},
    {1844, 3689, 3690},
    {1845, 3691, 3692},
    {1846, 3693, 3694},
    {1847, 3695, 3696},
    {1848, 3697, 3698},
    {1849, 3699, 3700},
    {1850, 3701, 3702},
    {1851, 3703, 3704},
    {1852, 3705, 3706},
    {1853, 3707, 3708},
    {1854, 3709, 3710},
    {1855, 3711, 3712},
    {1856, 3713, 3714}, // ########################################
    {1857, 3715, 3716},
    {1858, 3717, 3718},
    {1859, 3719, 3720},
    {1860, 3721, 3722},
    {1861, 3723, 3724},
    {1862, 3725, 3726},
    {1863, 3727, 3728},
    {1864, 3729, 3730},
    {1865, 3731, 3732},
    {1866, 3733, 3734},
    {1867, 3735, 3736},
    {1868, 3737, 3738},
    {1869, 3739, 3740},
    {1870, 3741, 3742},
    {1871, 3743, 3744},
    {1872, 3745, 3746},
    {1873, 3747, 3748},
    {1874, 3749, 3750},
    {1875, 3751, 3752},
    {1876, 3753, 3754},
    {1877, 3755, 3756},
    {1878, 3757, 3758},
    {1879, 3759, 3760},
    {1880, 3761, 3762},
    {1881, 3763, 3764},
    {1882, 3765, 3766},
    {1883, 3767, 3768},
    {1884, 3769, 3770},
    {1885, 3771, 3772},
    {1886, 3773, 3774},
    {1887, 3775, 3776},
    {1888, 3777, 3778},
    {1889, 3779, 3780},
    {1890, 3781, 3782},
    {1891, 3783, 3784},
    {1892, 3785, 3786},
    {1893, 3787, 3788},
    {1894, 3789, 3790},
    {1895, 3791, 3792},
    {1896, 3793, 3794},
    {1897, 3795, 3796},
    {1898, 3797, 3798},
    {1899, 3799, 3800},
    {1900, 3801, 3802},
    {1901, 3803, 3804},
    {1902, 3805, 3806},
    {1903, 3807, 3808},
    {1904, 3809, 3810},
    {1905, 3811, 3812},
    {1906, 3813, 3814},
    {1907, 3815, 3816},
    {1908, 3817, 3818},
    {1909, 3819, 3820},
    {1910, 3821, 3822},
    {1911, 3823, 3824},
    {1912, 3825, 3826},
    {1913, 3827, 3828},
    {1914, 3829, 3830},
    {1915, 3831, 3832},
    {1916, 3833, 3834},
    {1917, 3835, 3836},
    {1918, 3837, 3838},
    {1919, 3839, 3840},
    {1920, 3841, 3842}, // ########################################
    {1921, 3843, 3844},
    {1922, 3845, 3846},
    {1923, 3847, 3848},
    {1924, 3849, 3850},
    {1925, 3851, 3852},
    {1926, 3853, 3854},
    {1927, 3855, 3856},
    {1928, 3857, 3858},
    {1929, 3859, 3860},
    {1930, 3861, 3862},
    {1931, 3863, 3864},
    {1932, 3865, 3866},
    {1933, 3867, 3868},
    {1934, 3869, 3870},
    {1935, 3871, 3872},
    {1936, 3873, 3874},
    {1937, 3875, 3876},
    {1938, 3877, 3878},
    {1939, 3879, 3880},
    {1940, 3881, 3882},
    {1941, 3883, 3884},
    {1942, 3885, 3886},
    {1943, 3887, 3888},
    {1944, 3889, 3890},
    {1945, 3891, 3892},
    {1946, 3893, 3894},
    {1947, 3895, 3896},
    {1948, 3897, 3898},
    {1949, 3899, 3900},
    {1950, 3901, 3902},
    {1951, 3903, 3904},
    {1952, 3905, 3906},
    {1953, 3907, 3908},
    {1954, 3909, 3910},
    {1955, 3911, 3912},
    {1956, 3913, 3914},
    {1957, 3915, 3916},
    {1958, 3917, 3918},
    {1959, 3919, 3920},
    {1960, 3921, 3922},
    {1961, 3923, 3924},
    {1962, 3925, 3926},
    {1963, 3927, 3928},
    {1964, 3929, 3930},
    {1965, 3931, 3932},
    {1966, 3933, 3934},
    {1967, 3935, 3936},
    {1968, 3937, 3938},
    {1969, 3939, 3940},
    {1970, 3941, 3942},
    {1971, 3943, 3944},
    {1972, 3945, 3946},
    {1973, 3947, 3948},
    {1974, 3949, 3950},
    {1975, 3951, 3952},
    {1976, 3953, 3954},
    {1977, 3955, 3956},
    {1978, 3957, 3958},
    {1979, 3959, 3960},
    {1980, 3961, 3962},
    {1981, 3963, 3964},
    {1982, 3965, 3966},
    {1983, 3967, 3968},
    {1984, 3969, 3970}, // ########################################
    {1985, 3971, 3972},
    {1986, 3973, 3974},
    {1987, 3975, 3976},
    {1988, 3977, 3978},
    {1989, 3979, 3980},
    {1990, 3981, 3982},
    {1991, 3983, 3984},
    {1992, 3985, 3986},
    {1993, 3987, 3988},
    {1994, 3989, 3990},
    {1995, 3991, 3992},
    {1996, 3993, 3994},
    {1997, 3995, 3996},
    {1998, 3997, 3998},
    {1999, 3999, 4000},
    {2000, 4001, 4002},
    {2001, 4003, 4004},
    {2002, 4005, 4006},
    {2003, 4007, 4008},
    {2004, 4009, 4010},
    {2005, 4011, 4012},
    {2006, 4013, 4014},
    {2007, 4015, 4016},
    {2008, 4017, 4018},
    {2009, 4019, 4020},
    {2010, 4021, 4022},
    {2011, 4023, 4024},
    {2012, 4025, 4026},
    {2013, 4027, 4028},
    {2014, 4029, 4030},
    {2015, 4031, 4032},
    {2016, 4033, 4034},
    {2017, 4035, 4036},
    {2018, 4037, 4038},
    {2019, 4039, 4040},
    {2020, 4041, 4042},
    {2021, 4043, 4044},
    {2022, 4045, 4046},
    {2023, 4047, 4048},
    {2024, 4049, 4050},
    {2025, 4051, 4052},
    {2026, 4053, 4054},
    {2027, 4055, 4056},
    {2028, 4057, 4058},
    {2029, 4059, 4060},
    {2030, 4061, 4062},
    {2031, 4063, 4064},
    {2032, 4065, 4066},
    {2033, 4067, 4068},
    {2034, 4069, 4070},
    {2035, 4071, 4072},
    {2036, 4073, 4074},
    {2037, 4075, 4076},
    {2038, 4077, 4078},
    {2039, 4079, 4080},
    {2040, 4081, 4082},
    {2041, 4083, 4084},
    {2042, 4085, 4086},
    {2043, 4087, 4088},
    {2044, 4089, 4090},
    {2045, 4091, 4092},
    {2046, 4093, 4094},
    {2047, 4095, 4096},
    {2048, 4097, 4098}, // ########################################
    {2049, 4099, 4100},
    {2050, 4101, 4102},
    {2051, 4103, 4104},
    {2052, 4105, 4106},
    {2053, 4107, 4108},
    {2054, 4109, 4110},
    {2055, 4111, 4112},
    {2056, 4113, 4114},
    {2057, 4115, 4116},
    {2058, 4117, 4118},
    {2059, 4119, 4120},
    {2060, 4121, 4122},
    {2061, 4123, 4124},
    {2062, 4125, 4126},
    {2063, 4127, 4128},
    {2064, 4129, 4130},
    {2065, 4131, 4132},
    {2066, 4133, 4134},
    {2067, 4135, 4136},
    {2068, 4137, 4138},
    {2069, 4139, 4140},
    {2070, 4141, 4142},
    {2071, 4143, 4144},
    {2072, 4145, 4146},
    {2073, 4147, 4148},
    {2074, 4149, 4150},
    {2075, 4151, 4152},
    {2076, 4153, 4154},
    {2077, 4155, 4156},
    {2078, 4157, 4158},
    {2079, 4159, 4160},
    {2080, 4161, 4162},
    {2081, 4163, 4164},
    {2082, 4165, 4166},
    {2083, 4167, 4168},
    {2084, 4169, 4170},
    {2085, 4171, 4172},
    {2086, 4173, 4174},
    {2087, 4175, 4176},
    {2088, 4177, 4178},
    {2089, 4179, 4180},
    {2090, 4181, 4182},
    {2091, 4183, 4184},
    {2092, 4185, 4186},
    {2093, 4187, 4188},
    {2094, 4189, 4190},
    {2095, 4191, 4192},
    {2096, 4193, 4194},
    {2097, 4195, 4196},
    {2098, 4197, 4198},
    {2099, 4199, 4200},
    {2100, 4201, 4202},
    {2101, 4203, 4204},
    {2102, 4205, 4206},
    {2103, 4207, 4208},
    {2104, 4209, 4210},
    {2105, 4211, 4212},
    {2106, 4213, 4214},
    {2107, 4215, 4216},
    {2108, 4217, 4218},
    {2109, 4219, 4220},
    {2110, 4221, 4222},
    {2111, 4223, 4224},
    {2112, 4225, 4226}, // ########################################
    {2113, 4227, 4228},
    {2114, 4229, 4230},
    {2115, 4231, 4232},
    {2116, 4233, 4234},
    {2117, 4235, 4236},
    {2118, 4237, 4238},
    {2119, 4239, 4240},
    {2120, 4241, 4242},
    {2121, 4243, 4244},
    {2122, 4245, 4246},
    {2123, 4247, 4248},
    {2124, 4249, 4250},
    {2125, 4251, 4252},
    {2126, 4253, 4254},
    {2127, 4255, 4256},
    {2128, 4257, 4258},
    {2129, 4259, 4260},
    {2130, 4261, 4262},
    {2131, 4263, 4264},
    {2132, 4265, 4266},
    {2133, 4267, 4268},
    {2134, 4269, 4270},
    {2135, 4271, 4272},
    {2136, 4273, 4274},
    {2137, 4275, 4276},
    {2138, 4277, 4278},
    {2139, 4279, 4280},
    {2140, 4281, 4282},
    {2141, 4283, 4284},
    {2142, 4285, 4286},
    {2143, 4287, 4288},
    {2144, 4289, 4290},
    {2145, 4291, 4292},
    {2146, 4293, 4294},
    {2147, 4295, 4296},
    {2148, 4297, 4298},
    {2149, 4299, 4300},
    {2150, 4301, 4302},
    {2151, 4303, 4304},
    {2152, 4305, 4306},
    {2153, 4307, 4308},
    {2154, 4309, 4310},
    {2155, 4311, 4312},
    {2156, 4313, 4314},
    {2157, 4315, 4316},
    {2158, 4317, 4318},
    {2159, 4319, 4320},
    {2160, 4321, 4322},
    {2161, 4323, 4324},
    {2162, 4325, 4326},
    {2163, 4327, 4328},
    {2164, 4329, 4330},
    {2165, 4331, 4332},
    {2166, 4333, 4334},
    {2167, 4335, 4336},
    {2168, 4337, 4338},
    {2169, 4339, 4340},
    {2170, 4341, 4342},
    {2171, 4343, 4344},
    {2172, 4345, 4346},
    {2173, 4347, 4348},
    {2174, 4349, 4350},
    {2175, 4351, 4352},
    {2176, 4353, 4354}, // ########################################
    {2177, 4355, 4356},
    {2178, 4357, 4358},
    {2179, 4359, 4360},
    {2180, 4361, 4362},
    {2181, 4363, 4364},
    {2182, 4365, 4366},
    {2183, 4367, 4368},
    {2184, 4369, 4370},
    {2185, 4371, 4372},
    {2186, 4373, 4374},
    {2187, 4375, 4376},
    {2188, 4377, 4378},
    {2189, 4379, 4380},
    {2190, 4381, 4382},
    {2191, 4383, 4384},
    {2192, 4385, 4386},
    {2193, 4387, 4388},
    {2194, 4389, 4390},
    {2195, 4391, 4392},
    {2196, 4393, 4394},
    {2197, 4395, 4396},
    {2198, 4397, 4398},
    {2199, 4399, 4400},
    {2200, 4401, 4402},
    {2201, 4403, 4404},
    {2202, 4405, 4406},
    {2203, 4407, 4408},
    {2204, 4409, 4410},
    {2205, 4411, 4412},
    {2206, 4413, 4414},
    {2207, 4415, 4416},
    {2208, 4417, 4418},
    {2209, 4419, 4420},
    {2210, 4421, 4422},
    {2211, 4423, 4424},
    {2212, 4425, 4426},
    {2213, 4427, 4428},
    {2214, 4429, 4430},
    {2215, 4431, 4432},
    {2216, 4433, 4434},
    {2217, 4435, 4436},
    {2218, 4437, 4438},
    {2219, 4439, 4440},
    {2220, 4441, 4442},
    {2221, 4443, 4444},
    {2222, 4445, 4446},
    {2223, 4447, 4448},
    {2224, 4449, 4450},
    {2225, 4451, 4452},
    {2226, 4453, 4454},
    {2227, 4455, 4456},
    {2228, 4457, 4458},
    {2229, 4459, 4460},
    {2230, 4461, 4462},
    {2231, 4463, 4464},
    {2232, 4465, 4466},
    {2233, 4467, 4468},
    {2234, 4469, 4470},
    {2235, 4471, 4472},
    {2236, 4473, 4474},
    {2237, 4475, 4476},
    {2238, 4477, 4478},
    {2239, 4479, 4480},
    {2240, 4481, 4482}, // ########################################
    {2241, 4483, 4484},
    {2242, 4485, 4486},
    {2243, 4487, 4488},
    {2244, 4489, 4490},
    {2245, 4491, 4492},
    {2246, 4493, 4494},
    {2247, 4495, 4496},
    {2248, 4497, 4498},
    {2249, 4499, 4500},
    {2250, 4501, 4502},
    {2251, 4503, 4504},
    {2252, 4505, 4506},
    {2253, 4507, 4508},
    {2254, 4509, 4510},
    {2255, 4511, 4512},
    {2256, 4513, 4514},
    {2257, 4515, 4516},
    {2258, 4517, 4518},
    {2259, 4519, 4520},
    {2260, 4521, 4522},
    {2261, 4523, 4524},
    {2262, 4525, 4526},
    {2263, 4527, 4528},
    {2264, 4529, 4530},
    {2265, 4531, 4532},
    {2266, 4533, 4534},
    {2267, 4535, 4536},
    {2268, 4537, 4538},
    {2269, 4539, 4540},
    {2270, 4541, 4542},
    {2271, 4543, 4544},
    {2272, 4545, 4546},
    {2273, 4547, 4548},
    {2274, 4549, 4550},
    {2275, 4551, 4552},
    {2276, 4553, 4554},
    {2277, 4555, 4556},
    {2278, 4557, 4558},
    {2279, 4559, 4560},
    {2280, 4561, 4562},
    {2281, 4563, 4564},
    {2282, 4565, 4566},
    {2283, 4567, 4568},
    {2284, 4569, 4570},
    {2285, 4571, 4572},
    {2286, 4573, 4574},
    {2287, 4575, 4576},
    {2288, 4577, 4578},
    {2289, 4579, 4580},
    {2290, 4581, 4582},
    {2291, 4583, 4584},
    {2292, 4585, 4586},
    {2293, 4587, 4588},
    {2294, 4589, 4590},
    {2295, 4591, 4592},
    {2296, 4593, 4594},
    {2297, 4595, 4596},
    {2298, 4597, 4598},
    {2299, 4599, 4600},
    {2300, 4601, 4602},
    {2301, 4603, 4604},
    {2302, 4605, 4606},
    {2303, 4607, 4608},
    {2304, 4609, 4610}, // ########################################
    {2305, 4611, 4612},
    {2306, 4613, 4614},
    {2307, 4615, 4616},
    {2308, 4617, 4618},
    {2309, 4619, 4620},
    {2310, 4621, 4622},
    {2311, 4623, 4624},
    {2312, 4625, 4626},
    {2313, 4627, 4628},
    {2314, 4629, 4630},
    {2315, 4631, 4632},
    {2316, 4633, 4634},
    {2317, 4635, 4636},
    {2318, 4637, 4638},
    {2319, 4639, 4640},
    {2320, 4641, 4642},
    {2321, 4643, 4644},
    {2322, 4645, 4646},
    {2323, 4647, 4648},
    {2324, 4649, 4650},
    {2325, 4651, 4652},
    {2326, 4653, 4654},
    {2327, 4655, 4656},
    {2328, 4657, 4658},
    {2329, 4659, 4660},
    {2330, 4661, 4662},
    {2331, 4663, 4664},
    {2332, 4665, 4666},
    {2333, 4667, 4668},
    {2334, 4669, 4670},
    {2335, 4671, 4672},
    {2336, 4673, 4674},
    {2337, 4675, 4676},
    {2338, 4677, 4678},
    {2339, 4679, 4680},
    {2340, 4681, 4682},
    {2341, 4683, 4684},
    {2342, 4685, 4686},
    {2343, 4687, 4688},
    {2344, 4689, 4690},
    {2345, 4691, 4692},
    {2346, 4693, 4694},
    {2347, 4695, 4696},
    {2348, 4697, 4698},
    {2349, 4699, 4700},
    {2350, 4701, 4702},
    {2351, 4703, 4704},
    {2352, 4705, 4706},
    {2353, 4707, 4708},
    {2354, 4709, 4710},
    {2355, 4711, 4712},
    {2356, 4713, 4714},
    {2357, 4715, 4716},
    {2358, 4717, 4718},
    {2359, 4719, 4720},
    {2360, 4721, 4722},
    {2361, 4723, 4724},
    {2362, 4725, 4726},
    {2363, 4727, 4728},
    {2364, 4729, 4730},
    {2365, 4731, 4732},
    {2366, 4733, 4734},
    {2367, 4735, 4736},
    {2368, 4737, 4738}, // ########################################
    {2369, 4739, 4740},
    {2370, 4741, 4742},
    {2371, 4743, 4744},
    {2372, 4745, 4746},
    {2373, 4747, 4748},
    {2374, 4749, 4750},
    {2375, 4751, 4752},
    {2376, 4753, 4754},
    {2377, 4755, 4756},
    {2378, 4757, 4758},
    {2379, 4759, 4760},
    {2380, 4761, 4762},
    {2381, 4763, 4764},
    {2382, 4765, 4766},
    {2383, 4767, 4768},
    {2384, 4769, 4770},
    {2385, 4771, 4772},
    {2386, 4773, 4774},
    {2387, 4775, 4776},
    {2388, 4777, 4778},
    {2389, 4779, 4780},
    {2390, 4781, 4782},
    {2391, 4783, 4784},
    {2392, 4785, 4786},
    {2393, 4787, 4788},
    {2394, 4789, 4790},
    {2395, 4791, 4792},
    {2396, 4793, 4794},
    {2397, 4795, 4796},
    {2398, 4797, 4798},
    {2399, 4799, 4800},
    {2400, 4801, 4802},
    {2401, 4803, 4804},
    {2402, 4805, 4806},
    {2403, 4807, 4808},
    {2404, 4809, 4810},
    {2405, 4811, 4812},
    {2406, 4813, 4814},
    {2407, 4815, 4816},
    {2408, 4817, 4818},
    {2409, 4819, 4820},
    {2410, 4821, 4822},
    {2411, 4823, 4824},
    {2412, 4825, 4826},
    {2413, 4827, 4828},
    {2414, 4829, 4830},
    {2415, 4831, 4832},
    {2416, 4833, 4834},
    {2417, 4835, 4836},
    {2418, 4837, 4838},
    {2419, 4839, 4840},
    {2420, 4841, 4842},
    {2421, 4843, 4844},
    {2422, 4845, 4846},
    {2423, 4847, 4848},
    {2424, 4849, 4850},
    {2425, 4851, 4852},
    {2426, 4853, 4854},
    {2427, 4855, 4856},
    {2428, 4857, 4858},
    {2429, 4859, 4860},
    {2430, 4861, 4862},
    {2431, 4863, 4864},
    {2432, 4865, 4866}, // ########################################
    {2433, 4867, 4868},
    {2434, 4869, 4870},
    {2435, 4871, 4872},
    {2436, 4873, 4874},
    {2437, 4875, 4876},
    {2438, 4877, 4878},
    {2439, 4879, 4880},
    {2440, 4881, 4882},
    {2441, 4883, 4884},
    {2442, 4885, 4886},
    {2443, 4887, 4888},
    {2444, 4889, 4890},
    {2445, 4891, 4892},
    {2446, 4893, 4894},
    {2447, 4895, 4896},
    {2448, 4897, 4898},
    {2449, 4899, 4900},
    {2450, 4901, 4902},
    {2451, 4903, 4904},
    {2452, 4905, 4906},
    {2453, 4907, 4908},
    {2454, 4909, 4910},
    {2455, 4911, 4912},
    {2456, 4913, 4914},
    {2457, 4915, 4916},
    {2458, 4917, 4918},
    {2459, 4919, 4920},
    {2460, 4921, 4922},
    {2461, 4923, 4924},
    {2462, 4925, 4926},
    {2463, 4927, 4928},
    {2464, 4929, 4930},
    {2465, 4931, 4932},
    {2466, 4933, 4934},
    {2467, 4935, 4936},
    {2468, 4937, 4938},
    {2469, 4939, 4940},
    {2470, 4941, 4942},
    {2471, 4943, 4944},
    {2472, 4945, 4946},
    {2473, 4947, 4948},
    {2474, 4949, 4950},
    {2475, 4951, 4952},
    {2476, 4953, 4954},
    {2477, 4955, 4956},
    {2478, 4957, 4958},
    {2479, 4959, 4960},
    {2480, 4961, 4962},
    {2481, 4963, 4964},
    {2482, 4965, 4966},
    {2483, 4967, 4968},
    {2484, 4969, 4970},
    {2485, 4971, 4972},
    {2486, 4973, 4974},
    {2487, 4975, 4976},
    {2488, 4977, 4978},
    {2489, 4979, 4980},
    {2490, 4981, 4982},
    {2491, 4983, 4984},
    {2492, 4985, 4986},
    {2493, 4987, 4988},
    {2494, 4989, 4990},
    {2495, 4991, 4992},
    {2496, 4993, 4994}, // ########################################
    {2497, 4995, 4996},
    {2498, 4997, 4998},
    {2499, 4999, 5000},
    {2500, 5001, 5002},
    {2501, 5003, 5004},
    {2502, 5005, 5006},
    {2503, 5007, 5008},
    {2504, 5009, 5010},
    {2505, 5011, 5012},
    {2506, 5013, 5014},
    {2507, 5015, 5016},
    {2508, 5017, 5018},
    {2509, 5019, 5020},
    {2510, 5021, 5022},
    {2511, 5023, 5024},
    {2512, 5025, 5026},
    {2513, 5027, 5028},
    {2514, 5029, 5030},
    {2515, 5031, 5032},
    {2516, 5033, 5034},
    {2517, 5035, 5036},
    {2518, 5037, 5038},
    {2519, 5039, 5040},
    {2520, 5041, 5042},
    {2521, 5043, 5044},
    {2522, 5045, 5046},
    {2523, 5047, 5048},
    {2524, 5049, 5050},
    {2525, 5051, 5052},
    {2526, 5053, 5054},
    {2527, 5055, 5056},
    {2528, 5057, 5058},
    {2529, 5059, 5060},
    {2530, 5061, 5062},
    {2531, 5063, 5064},
    {2532, 5065, 5066},
    {2533, 5067, 5068},
    {2534, 5069, 5070},
    {2535, 5071, 5072},
    {2536, 5073, 5074},
    {2537, 5075, 5076},
    {2538, 5077, 5078},
    {2539, 5079, 5080},
    {2540, 5081, 5082},
    {2541, 5083, 5084},
    {2542, 5085, 5086},
    {2543, 5087, 5088},
    {2544, 5089, 5090},
    {2545, 5091, 5092},
    {2546, 5093, 5094},
    {2547, 5095, 5096},
    {2548, 5097, 5098},
    {2549, 5099, 5100},
    {2550, 5101, 5102},
    {2551, 5103, 5104},
    {2552, 5105, 5106},
    {2553, 5107, 5108},
    {2554, 5109, 5110},
    {2555, 5111, 5112},
    {2556, 5113, 5114},
    {2557, 5115, 5116},
    {2558, 5117, 5118},
    {2559, 5119, 5120},
    {2560, 5121, 5122}, // ########################################
    {2561, 5123, 5124},
    {2562, 5125, 5126},
    {2563, 5127, 5128},
    {2564, 5129, 5130},
    {2565, 5131, 5132},
    {2566, 5133, 5134},
    {2567, 5135, 5136},
    {2568, 5137, 5138},
    {2569, 5139, 5140},
    {2570, 5141, 5142},
    {2571, 5143, 5144},
    {2572, 5145, 5146},
    {2573, 5147, 5148},
    {2574, 5149, 5150},
    {2575, 5151, 5152},
    {2576, 5153, 5154},
    {2577, 5155, 5156},
    {2578, 5157, 5158},
    {2579, 5159, 5160},
    {2580, 5161, 5162},
    {2581, 5163, 5164},
    {2582, 5165, 5166},
    {2583, 5167, 5168},
    {2584, 5169, 5170},
    {2585, 5171, 5172},
    {2586, 5173, 5174},
    {2587, 5175, 5176},
    {2588, 5177, 5178},
    {2589, 5179, 5180},
    {2590, 5181, 5182},
    {2591, 5183, 5184},
    {2592, 5185, 5186},
    {2593, 5187, 5188},
    {2594, 5189, 5190},
    {2595, 5191, 5192},
    {2596, 5193, 5194},
    {2597, 5195, 5196},
    {2598, 5197, 5198},
    {2599, 5199, 5200},
    {2600, 5201, 5202},
    {2601, 5203, 5204},
    {2602, 5205, 5206},
    {2603, 5207, 5208},
    {2604, 5209, 5210},
    {2605, 5211, 5212},
    {2606, 5213, 5214},
    {2607, 5215, 5216},
    {2608, 5217, 5218},
    {2609, 5219, 5220},
    {2610, 5221, 5222},
    {2611, 5223, 5224},
    {2612, 5225, 5226},
    {2613, 5227, 5228},
    {2614, 5229, 5230},
    {2615, 5231, 5232},
    {2616, 5233, 5234},
    {2617, 5235, 5236},
    {2618, 5237, 5238},
    {2619, 5239, 5240},
    {2620, 5241, 5242},
    {2621, 5243, 5244},
    {2622, 5245, 5246},
    {2623, 5247, 5248},
    {2624, 5249, 5250}, // ########################################
    {2625, 5251, 5252},
    {2626, 5253, 5254},
    {2627, 5255, 5256},
    {2628, 5257, 5258},
    {2629, 5259, 5260},
    {2630, 5261, 5262},
    {2631, 5263, 5264},
    {2632, 5265, 5266},
    {2633, 5267, 5268},
    {2634, 5269, 5270},
    {2635, 5271, 5272},
    {2636, 5273, 5274},
    {2637, 5275, 5276},
    {2638, 5277, 5278},
    {2639, 5279, 5280},
    {2640, 5281, 5282},
    {2641, 5283, 5284},
    {2642, 5285, 5286},
    {2643, 5287, 5288},
    {2644, 5289, 5290},
    {2645, 5291, 5292},
    {2646, 5293, 5294},
    {2647, 5295, 5296},
    {2648, 5297, 5298},
    {2649, 5299, 5300},
    {2650, 5301, 5302},
    {2651, 5303, 5304},
    {2652, 5305, 5306},
    {2653, 5307, 5308},
    {2654, 5309, 5310},
    {2655, 5311, 5312},
    {2656, 5313, 5314},
    {2657, 5315, 5316},
    {2658, 5317, 5318},
    {2659, 5319, 5320},
    {2660, 5321, 5322},
    {2661, 5323, 5324},
    {2662, 5325, 5326},
    {2663, 5327, 5328},
    {2664, 5329, 5330},
    {2665, 5331, 5332},
    {2666, 5333, 5334},
    {2667, 5335, 5336},
    {2668, 5337, 5338},
    {2669, 5339, 5340},
    {2670, 5341, 5342},
    {2671, 5343, 5344},
    {2672, 5345, 5346},
    {2673, 5347, 5348},
    {2674, 5349, 5350},
    {2675, 5351, 5352},
    {2676, 5353, 5354},
    {2677, 5355, 5356},
    {2678, 5357, 5358},
    {2679, 5359, 5360},
    {2680, 5361, 5362},
    {2681, 5363, 5364},
    {2682, 5365, 5366},
    {2683, 5367, 5368},
    {2684, 5369, 5370},
    {2685, 5371, 5372},
    {2686, 5373, 5374},
    {2687, 5375, 5376},
    {2688, 5377, 5378}, // ########################################
    {2689, 5379, 5380},
    {2690, 5381, 5382},
    {2691, 5383, 5384},
    {2692, 5385, 5386},
    {2693, 5387, 5388},
    {2694, 5389, 5390},
    {2695, 5391, 5392},
    {2696, 5393, 5394},
    {2697, 5395, 5396},
    {2698, 5397, 5398},
    {2699, 5399, 5400},
    {2700, 5401, 5402},
    {2701, 5403, 5404},
    {2702, 5405, 5406},
    {2703, 5407, 5408},
    {2704, 5409, 5410},
    {2705, 5411, 5412},
    {2706, 5413, 5414},
    {2707, 5415, 5416},
    {2708, 5417, 5418},
    {2709, 5419, 5420},
    {2710, 5421, 5422},
    {2711, 5423, 5424},
    {2712, 5425, 5426},
    {2713, 5427, 5428},
    {2714, 5429, 5430},
    {2715, 5431, 5432},
    {2716, 5433, 5434},
    {2717, 5435, 5436},
    {2718, 5437, 5438},
    {2719, 5439, 5440},
    {2720, 5441, 5442},
    {2721, 5443, 5444},
    {2722, 5445, 5446},
    {2723, 5447, 5448},
    {2724, 5449, 5450},
    {2725, 5451, 5452},
    {2726, 5453, 5454},
    {2727, 5455, 5456},
    {2728, 5457, 5458},
    {2729, 5459, 5460},
    {2730, 5461, 5462},
    {2731, 5463, 5464},
    {2732, 5465, 5466},
    {2733, 5467, 5468},
    {2734, 5469, 5470},
    {2735, 5471, 5472},
    {2736, 5473, 5474},
    {2737, 5475, 5476},
    {2738, 5477, 5478},
    {2739, 5479, 5480},
    {2740, 5481, 5482},
    {2741, 5483, 5484},
    {2742, 5485, 5486},
    {2743, 5487, 5488},
    {2744, 5489, 5490},
    {2745, 5491, 5492},
    {2746, 5493, 5494},
    {2747, 5495, 5496},
    {2748, 5497, 5498},
    {2749, 5499, 5500},
    {2750, 5501, 5502},
    {2751, 5503, 5504},
    {2752, 5505, 5506}, // ########################################
    {2753, 5507, 5508},
    {2754, 5509, 5510},
    {2755, 5511, 5512},
    {2756, 5513, 5514},
    {2757, 5515, 5516},
    {2758, 5517, 5518},
    {2759, 5519, 5520},
    {2760, 5521, 5522},
    {2761, 5523, 5524},
    {2762, 5525, 5526},
    {2763, 5527, 5528},
    {2764, 5529, 5530},
    {2765, 5531, 5532},
    {2766, 5533, 5534},
    {2767, 5535, 5536},
    {2768, 5537, 5538},
    {2769, 5539, 5540},
    {2770, 5541, 5542},
    {2771, 5543, 5544},
    {2772, 5545, 5546},
    {2773, 5547, 5548},
    {2774, 5549, 5550},
    {2775, 5551, 5552},
    {2776, 5553, 5554},
    {2777, 5555, 5556},
    {2778, 5557, 5558},
    {2779, 5559, 5560},
    {2780, 5561, 5562},
    {2781, 5563, 5564},
    {2782, 5565, 5566},
    {2783, 5567, 5568},
    {2784, 5569, 5570},
    {2785, 5571, 5572},
    {2786, 5573, 5574},
    {2787, 5575, 5576},
    {2788, 5577, 5578},
    {2789, 5579, 5580},
    {2790, 5581, 5582},
    {2791, 5583, 5584},
    {2792, 5585, 5586},
    {2793, 5587, 5588},
    {2794, 5589, 5590},
    {2795, 5591, 5592},
    {2796, 5593, 5594},
    {2797, 5595, 5596},
    {2798, 5597, 5598},
    {2799, 5599, 5600},
    {2800, 5601, 5602},
    {2801, 5603, 5604},
    {2802, 5605, 5606},
    {2803, 5607, 5608},
    {2804, 5609, 5610},
    {2805, 5611, 5612},
    {2806, 5613, 5614},
    {2807, 5615, 5616},
    {2808, 5617, 5618},
    {2809, 5619, 5620},
    {2810, 5621, 5622},
    {2811, 5623, 5624},
    {2812, 5625, 5626},
    {2813, 5627, 5628},
    {2814, 5629, 5630},
    {2815, 5631, 5632},
    {2816, 5633, 5634}, // ########################################
    {2817, 5635, 5636},
    {2818, 5637, 5638},
    {2819, 5639, 5640},
    {2820, 5641, 5642},
    {2821, 5643, 5644},
    {2822, 5645, 5646},
    {2823, 5647, 5648},
    {2824, 5649, 5650},
    {2825, 5651, 5652},
    {2826, 5653, 5654},
    {2827, 5655, 5656},
    {2828, 5657, 5658},
    {2829, 5659, 5660},
    {2830, 5661, 5662},
    {2831, 5663, 5664},
    {2832, 5665, 5666},
    {2833, 5667, 5668},
    {2834, 5669, 5670},
    {2835, 5671, 5672},
    {2836, 5673, 5674},
    {2837, 5675, 5676},
    {2838, 5677, 5678},
    {2839, 5679, 5680},
    {2840, 5681, 5682},
    {2841, 5683, 5684},
    {2842, 5685, 5686},
    {2843, 5687, 5688},
    {2844, 5689, 5690},
    {2845, 5691, 5692},
    {2846, 5693, 5694},
    {2847, 5695, 5696},
    {2848, 5697, 5698},
    {2849, 5699, 5700},
    {2850, 5701, 5702},
    {2851, 5703, 5704},
    {2852, 5705, 5706},
    {2853, 5707, 5708},
    {2854, 5709, 5710},
    {2855, 5711, 5712},
    {2856, 5713, 5714},
    {2857, 5715, 5716},
    {2858, 5717, 5718},
    {2859, 5719, 5720},
    {2860, 5721, 5722},
    {2861, 5723, 5724},
    {2862, 5725, 5726},
    {2863, 5727, 5728},
    {2864, 5729, 5730},
    {2865, 5731, 5732},
    {2866, 5733, 5734},
    {2867, 5735, 5736},
    {2868, 5737, 5738},
    {2869, 5739, 5740},
    {2870, 5741, 5742},
    {2871, 5743, 5744},
    {2872, 5745, 5746},
    {2873, 5747, 5748},
    {2874, 5749, 5750},
    {2875, 5751, 5752},
    {2876, 5753, 5754},
    {2877, 5755, 5756},
    {2878, 5757, 5758},
    {2879, 5759, 5760},
    {2880, 5761, 5762}, // ########################################
    {2881, 5763, 5764},
    {2882, 5765, 5766},
    {2883, 5767, 5768},
    {2884, 5769, 5770},
    {2885, 5771, 5772},
    {2886, 5773, 5774},
    {2887, 5775, 5776},
    {2888, 5777, 5778},
    {2889, 5779, 5780},
    {2890, 5781, 5782},
    {2891, 5783, 5784},
    {2892, 5785, 5786},
    {2893, 5787, 5788},
    {2894, 5789, 5790},
    {2895, 5791, 5792},
    {2896, 5793, 5794},
    {2897, 5795, 5796},
    {2898, 5797, 5798},
    {2899, 5799, 5800},
    {2900, 5801, 5802},
    {2901, 5803, 5804},
    {2902, 5805, 5806},
    {2903, 5807, 5808},
    {2904, 5809, 5810},
    {2905, 5811, 5812},
    {2906, 5813, 5814},
    {2907, 5815, 5816},
    {2908, 5817, 5818},
    {2909, 5819, 5820},
    {2910, 5821, 5822},
    {2911, 5823, 5824},
    {2912, 5825, 5826},
    {2913, 5827, 5828},
    {2914, 5829, 5830},
    {2915, 5831, 5832},
    {2916, 5833, 5834},
    {2917, 5835, 5836},
    {2918, 5837, 5838},
    {2919, 5839, 5840},
    {2920, 5841, 5842},
    {2921, 5843, 5844},
    {2922, 5845, 5846},
    {2923, 5847, 5848},
    {2924, 5849, 5850},
    {2925, 5851, 5852},
    {2926, 5853, 5854},
    {2927, 5855, 5856},
    {2928, 5857, 5858},
    {2929, 5859, 5860},
    {2930, 5861, 5862},
    {2931, 5863, 5864},
    {2932, 5865, 5866},
    {2933, 5867, 5868},
    {2934, 5869, 5870},
    {2935, 5871, 5872},
    {2936, 5873, 5874},
    {2937, 5875, 5876},
    {2938, 5877, 5878},
    {2939, 5879, 5880},
    {2940, 5881, 5882},
    {2941, 5883, 5884},
    {2942, 5885, 5886},
    {2943, 5887, 5888},
    {2944, 5889, 5890}, // ########################################
    {2945, 5891, 5892},
    {2946, 5893, 5894},
    {2947, 5895, 5896},
    {2948, 5897, 5898},
    {2949, 5899, 5900},
    {2950, 5901, 5902},
    {2951, 5903, 5904},
    {2952, 5905, 5906},
    {2953, 5907, 5908},
    {2954, 5909, 5910},
    {2955, 5911, 5912},
    {2956, 5913, 5914},
    {2957, 5915, 5916},
    {2958, 5917, 5918},
    {2959, 5919, 5920},
    {2960, 5921, 5922},
    {2961, 5923, 5924},
    {2962, 5925, 5926},
    {2963, 5927, 5928},
    {2964, 5929, 5930},
    {2965, 5931, 5932},
    {2966, 5933, 5934},
    {2967, 5935, 5936},
    {2968, 5937, 5938},
    {2969, 5939, 5940},
    {2970, 5941, 5942},
    {2971, 5943, 5944},
    {2972, 5945, 5946},
    {2973, 5947, 5948},
    {2974, 5949, 5950},
    {2975, 5951, 5952},
    {2976, 5953, 5954},
    {2977, 5955, 5956},
    {2978, 5957, 5958},
    {2979, 5959, 5960},
    {2980, 5961, 5962},
    {2981, 5963, 5964},
    {2982, 5965, 5966},
    {2983, 5967, 5968},
    {2984, 5969, 5970},
    {2985, 5971, 5972},
    {2986, 5973, 5974},
    {2987, 5975, 5976},
    {2988, 5977, 5978},
    {2989, 5979, 5980},
    {2990, 5981, 5982},
    {2991, 5983, 5984},
    {2992, 5985, 5986},
    {2993, 5987, 5988},
    {2994, 5989, 5990},
    {2995, 5991, 5992},
    {2996, 5993, 5994},
    {2997, 5995, 5996},
    {2998, 5997, 5998},
    {2999, 5999, 6000},
    {3000, 6001, 6002},
    {3001, 6003, 6004},
    {3002, 6005, 6006},
    {3003, 6007, 6008},
    {3004, 6009, 6010},
    {3005, 6011, 6012},
    {3006, 6013, 6014},
    {3007, 6015, 6016},
    {3008, 6017, 6018}, // ########################################
    {3009, 6019, 6020},
    {3010, 6021, 6022},
    {3011, 6023, 6024},
    {3012, 6025, 6026},
    {3013, 6027, 6028},
    {3014, 6029, 6030},
    {3015, 6031, 6032},
    {3016, 6033, 6034},
    {3017, 6035, 6036},
    {3018, 6037, 6038},
    {3019, 6039, 6040},
    {3020, 6041, 6042},
    {3021, 6043, 6044},
    {3022, 6045, 6046},
    {3023, 6047, 6048},
    {3024, 6049, 6050},
    {3025, 6051, 6052},
    {3026, 6053, 6054},
    {3027, 6055, 6056},
    {3028, 6057, 6058},
    {3029, 6059, 6060},
    {3030, 6061, 6062},
    {3031, 6063, 6064},
    {3032, 6065, 6066},
    {3033, 6067, 6068},
    {3034, 6069, 6070},
    {3035, 6071, 6072},
    {3036, 6073, 6074},
    {3037, 6075, 6076},
    {3038, 6077, 6078},
    {3039, 6079, 6080},
    {3040, 6081, 6082},
    {3041, 6083, 6084},
    {3042, 6085, 6086},
    {3043, 6087, 6088},
    {3044, 6089, 6090},
    {3045, 6091, 6092},
    {3046, 6093, 6094},
    {3047, 6095, 6096},
    {3048, 6097, 6098},
    {3049, 6099, 6100},
    {3050, 6101, 6102},
    {3051, 6103, 6104},
    {3052, 6105, 6106},
    {3053, 6107, 6108},
    {3054, 6109, 6110},
    {3055, 6111, 6112},
    {3056, 6113, 6114},
    {3057, 6115, 6116},
    {3058, 6117, 6118},
    {3059, 6119, 6120},
    {3060, 6121, 6122},
    {3061, 6123, 6124},
    {3062, 6125, 6126},
    {3063, 6127, 6128},
    {3064, 6129, 6130},
    {3065, 6131, 6132},
    {3066, 6133, 6134},
    {3067, 6135, 6136},
    {3068, 6137, 6138},
    {3069, 6139, 6140},
    {3070, 6141, 6142},
    {3071, 6143, 6144},
    {3072, 6145, 6146}, // ########################################
    {3073, 6147, 6148},
    {3074, 6149, 6150},
    {3075, 6151, 6152},
    {3076, 6153, 6154},
    {3077, 6155, 6156},
    {3078, 6157, 6158},
    {3079, 6159, 6160},
    {3080, 6161, 6162},
    {3081, 6163, 6164},
    {3082, 6165, 6166},
    {3083, 6167, 6168},
    {3084, 6169, 6170},
    {3085, 6171, 6172},
    {3086, 6173, 6174},
    {3087, 6175, 6176},
    {3088, 6177, 6178},
    {3089, 6179, 6180},
    {3090, 6181, 6182},
    {3091, 6183, 6184},
    {3092, 6185, 6186},
    {3093, 6187, 6188},
    {3094, 6189, 6190},
    {3095, 6191, 6192},
    {3096, 6193, 6194},
    {3097, 6195, 6196},
    {3098, 6197, 6198},
    {3099, 6199, 6200},
    {3100, 6201, 6202},
    {3101, 6203, 6204},
    {3102, 6205, 6206},
    {3103, 6207, 6208},
    {3104, 6209, 6210},
    {3105, 6211, 6212},
    {3106, 6213, 6214},
    {3107, 6215, 6216},
    {3108, 6217, 6218},
    {3109, 6219, 6220},
    {3110, 6221, 6222},
    {3111, 6223, 6224},
    {3112, 6225, 6226},
    {3113, 6227, 6228},
    {3114, 6229, 6230},
    {3115, 6231, 6232},
    {3116, 6233, 6234},
    {3117, 6235, 6236},
    {3118, 6237, 6238},
    {3119, 6239, 6240},
    {3120, 6241, 6242},
    {3121, 6243, 6244},
    {3122, 6245, 6246},
    {3123, 6247, 6248},
    {3124, 6249, 6250},
    {3125, 6251, 6252},
    {3126, 6253, 6254},
    {3127, 6255, 6256},
    {3128, 6257, 6258},
    {3129, 6259, 6260},
    {3130, 6261, 6262},
    {3131, 6263, 6264},
    {3132, 6265, 6266},
    {3133, 6267, 6268},
    {3134, 6269, 6270},
    {3135, 6271, 6272},
    {3136, 6273, 6274}, // ########################################
    {3137, 6275, 6276},
    {3138, 6277, 6278},
    {3139, 6279, 6280},
    {3140, 6281, 6282},
    {3141, 6283, 6284},
    {3142, 6285, 6286},
    {3143, 6287, 6288},
    {3144, 6289, 6290},
    {3145, 6291, 6292},
    {3146, 6293, 6294},
    {3147, 6295, 6296},
    {3148, 6297, 6298},
    {3149, 6299, 6300},
    {3150, 6301, 6302},
    {3151, 6303, 6304},
    {3152, 6305, 6306},
    {3153, 6307, 6308},
    {3154, 6309, 6310},
    {3155, 6311, 6312},
    {3156, 6313, 6314},
    {3157, 6315, 6316},
    {3158, 6317, 6318},
    {3159, 6319, 6320},
    {3160, 6321, 6322},
    {3161, 6323, 6324},
    {3162, 6325, 6326},
    {3163, 6327, 6328},
    {3164, 6329, 6330},
    {3165, 6331, 6332},
    {3166, 6333, 6334},
    {3167, 6335, 6336},
    {3168, 6337, 6338},
    {3169, 6339, 6340},
    {3170, 6341, 6342},
    {3171, 6343, 6344},
    {3172, 6345, 6346},
    {3173, 6347, 6348},
    {3174, 6349, 6350},
    {3175, 6351, 6352},
    {3176, 6353, 6354},
    {3177, 6355, 6356},
    {3178, 6357, 6358},
    {3179, 6359, 6360},
    {3180, 6361, 6362},
    {3181, 6363, 6364},
    {3182, 6365, 6366},
    {3183, 6367, 6368},
    {3184, 6369, 6370},
    {3185, 6371, 6372},
    {3186, 6373, 6374},
    {3187, 6375, 6376},
    {3188, 6377, 6378},
    {3189, 6379, 6380},
    {3190, 6381, 6382},
    {3191, 6383, 6384},
    {3192, 6385, 6386},
    {3193, 6387, 6388},
    {3194, 6389, 6390},
    {3195, 6391, 6392},
    {3196, 6393, 6394},
    {3197, 6395, 6396},
    {3198, 6397, 6398},
    {3199, 6399, 6400},
    {3200, 6401, 6402}, // ########################################
    {3201, 6403, 6404},
    {3202, 6405, 6406},
    {3203, 6407, 6408},
    {3204, 6409, 6410},
    {3205, 6411, 6412},
    {3206, 6413, 6414},
    {3207, 6415, 6416},
    {3208, 6417, 6418},
    {3209, 6419, 6420},
    {3210, 6421, 6422},
    {3211, 6423, 6424},
    {3212, 6425, 6426},
    {3213, 6427, 6428},
    {3214, 6429, 6430},
    {3215, 6431, 6432},
    {3216, 6433, 6434},
    {3217, 6435, 6436},
    {3218, 6437, 6438},
    {3219, 6439, 6440},
    {3220, 6441, 6442},
    {3221, 6443, 6444},
    {3222, 6445, 6446},
    {3223, 6447, 6448},
    {3224, 6449, 6450},
    {3225, 6451, 6452},
    {3226, 6453, 6454},
    {3227, 6455, 6456},
    {3228, 6457, 6458},
    {3229, 6459, 6460},
    {3230, 6461, 6462},
    {3231, 6463, 6464},
    {3232, 6465, 6466},
    {3233, 6467, 6468},
    {3234, 6469, 6470},
    {3235, 6471, 6472},
    {3236, 6473, 6474},
    {3237, 6475, 6476},
    {3238, 6477, 6478},
    {3239, 6479, 6480},
    {3240, 6481, 6482},
    {3241, 6483, 6484},
    {3242, 6485, 6486},
    {3243, 6487, 6488},
    {3244, 6489, 6490},
    {3245, 6491, 6492},
    {3246, 6493, 6494},
    {3247, 6495, 6496},
    {3248, 6497, 6498},
    {3249, 6499, 6500},
    {3250, 6501, 6502},
    {3251, 6503, 6504},
    {3252, 6505, 6506},
    {3253, 6507, 6508},
    {3254, 6509, 6510},
    {3255, 6511, 6512},
    {3256, 6513, 6514},
    {3257, 6515, 6516},
    {3258, 6517, 6518},
    {3259, 6519, 6520},
    {3260, 6521, 6522},
    {3261, 6523, 6524},
    {3262, 6525, 6526},
    {3263, 6527, 6528},
    {3264, 6529, 6530}, // ########################################
    {3265, 6531, 6532},
    {3266, 6533, 6534},
    {3267, 6535, 6536},
    {3268, 6537, 6538},
    {3269, 6539, 6540},
    {3270, 6541, 6542},
    {3271, 6543, 6544},
    {3272, 6545, 6546},
    {3273, 6547, 6548},
    {3274, 6549, 6550},
    {3275, 6551, 6552},
    {3276, 6553, 6554},
    {3277, 6555, 6556},
    {3278, 6557, 6558},
    {3279, 6559, 6560},
    {3280, 6561, 6562},
    {3281, 6563, 6564},
    {3282, 6565, 6566},
    {3283, 6567, 6568},
    {3284, 6569, 6570},
    {3285, 6571, 6572},
    {3286, 6573, 6574},
    {3287, 6575, 6576},
    {3288, 6577, 6578},
    {3289, 6579, 6580},
    {3290, 6581, 6582},
    {3291, 6583, 6584},
    {3292, 6585, 6586},
    {3293, 6587, 6588},
    {3294, 6589, 6590},
    {3295, 6591, 6592},
    {3296, 6593, 6594},
    {3297, 6595, 6596},
    {3298, 6597, 6598},
    {3299, 6599, 6600},
    {3300, 6601, 6602},
    {3301, 6603, 6604},
    {3302, 6605, 6606},
    {3303, 6607, 6608},
    {3304, 6609, 6610},
    {3305, 6611, 6612},
    {3306, 6613, 6614},
    {3307, 6615, 6616},
    {3308, 6617, 6618},
    {3309, 6619, 6620},
    {3310, 6621, 6622},
    {3311, 6623, 6624},
    {3312, 6625, 6626},
    {3313, 6627, 6628},
    {3314, 6629, 6630},
    {3315, 6631, 6632},
    {3316, 6633, 6634},
    {3317, 6635, 6636},
    {3318, 6637, 6638},
    {3319, 6639, 6640},
    {3320, 6641, 6642},
    {3321, 6643, 6644},
    {3322, 6645, 6646},
    {3323, 6647, 6648},
    {3324, 6649, 6650},
    {3325, 6651, 6652},
    {3326, 6653, 6654},
    {3327, 6655, 6656},
    {3328, 6657, 6658}, // ########################################
    {3329, 6659, 6660},
    {3330, 6661, 6662},
    {3331, 6663, 6664},
    {3332, 6665, 6666},
    {3333, 6667, 6668},
    {3334, 6669, 6670},
    {3335, 6671, 6672},
    {3336, 6673, 6674},
    {3337, 6675, 6676},
    {3338, 6677, 6678},
    {3339, 6679, 6680},
    {3340, 6681, 6682},
    {3341, 6683, 6684},
    {3342, 6685, 6686},
    {3343, 6687, 6688},
    {3344, 6689, 6690},
    {3345, 6691, 6692},
    {3346, 6693, 6694},
    {3347, 6695, 6696},
    {3348, 6697, 6698},
    {3349, 6699, 6700},
    {3350, 6701, 6702},
    {3351, 6703, 6704},
    {3352, 6705, 6706},
    {3353, 6707, 6708},
    {3354, 6709, 6710},
    {3355, 6711, 6712},
    {3356, 6713, 6714},
    {3357, 6715, 6716},
    {3358, 6717, 6718},
    {3359, 6719, 6720},
    {3360, 6721, 6722},
    {3361, 6723, 6724},
    {3362, 6725, 6726},
    {3363, 6727, 6728},
    {3364, 6729, 6730},
    {3365, 6731, 6732},
    {3366, 6733, 6734},
    {3367, 6735, 6736},
    {3368, 6737, 6738},
    {3369, 6739, 6740},
    {3370, 6741, 6742},
    {3371, 6743, 6744},
    {3372, 6745, 6746},
    {3373, 6747, 6748},
    {3374, 6749, 6750},
    {3375, 6751, 6752},
    {3376, 6753, 6754},
    {3377, 6755, 6756},
    {3378, 6757, 6758},
    {3379, 6759, 6760},
    {3380, 6761, 6762},
    {3381, 6763, 6764},
    {3382, 6765, 6766},
    {3383, 6767, 6768},
    {3384, 6769, 6770},
    {3385, 6771, 6772},
    {3386, 6773, 6774},
    {3387, 6775, 6776},
    {3388, 6777, 6778},
    {3389, 6779, 6780},
    {3390, 6781, 6782},
    {3391, 6783, 6784},
    {3392, 6785, 6786}, // ########################################
    {3393, 6787, 6788},
    {3394, 6789, 6790},
    {3395, 6791, 6792},
    {3396, 6793, 6794},
    {3397, 6795, 6796},
    {3398, 6797, 6798},
    {3399, 6799, 6800},
    {3400, 6801, 6802},
    {3401, 6803, 6804},
    {3402, 6805, 6806},
    {3403, 6807, 6808},
    {3404, 6809, 6810},
    {3405, 6811, 6812},
    {3406, 6813, 6814},
    {3407, 6815, 6816},
    {3408, 6817, 6818},
    {3409, 6819, 6820},
    {3410, 6821, 6822},
    {3411, 6823, 6824},
    {3412, 6825, 6826},
    {3413, 6827, 6828},
    {3414, 6829, 6830},
    {3415, 6831, 6832},
    {3416, 6833, 6834},
    {3417, 6835, 6836},
    {3418, 6837, 6838},
    {3419, 6839, 6840},
    {3420, 6841, 6842},
    {3421, 6843, 6844},
    {3422, 6845, 6846},
    {3423, 6847, 6848},
    {3424, 6849, 6850},
    {3425, 6851, 6852},
    {3426, 6853, 6854},
    {3427, 6855, 6856},
    {3428, 6857, 6858},
    {3429, 6859, 6860},
    {3430, 6861, 6862},
    {3431, 6863, 6864},
    {3432, 6865, 6866},
    {3433, 6867, 6868},
    {3434, 6869, 6870},
    {3435, 6871, 6872},
    {3436, 6873, 6874},
    {3437, 6875, 6876},
    {3438, 6877, 6878},
    {3439, 6879, 6880},
    {3440, 6881, 6882},
    {3441, 6883, 6884},
    {3442, 6885, 6886},
    {3443, 6887, 6888},
    {3444, 6889, 6890},
    {3445, 6891, 6892},
    {3446, 6893, 6894},
    {3447, 6895, 6896},
    {3448, 6897, 6898},
    {3449, 6899, 6900},
    {3450, 6901, 6902},
    {3451, 6903, 6904},
    {3452, 6905, 6906},
    {3453, 6907, 6908},
    {3454, 6909, 6910},
    {3455, 6911, 6912},
    {3456, 6913, 6914}, // ########################################
    {3457, 6915, 6916},
    {3458, 6917, 6918},
    {3459, 6919, 6920},
    {3460, 6921, 6922},
    {3461, 6923, 6924},
    {3462, 6925, 6926},
    {3463, 6927, 6928},
    {3464, 6929, 6930},
    {3465, 6931, 6932},
    {3466, 6933, 6934},
    {3467, 6935, 6936},
    {3468, 6937, 6938},
    {3469, 6939, 6940},
    {3470, 6941, 6942},
    {3471, 6943, 6944},
    {3472, 6945, 6946},
    {3473, 6947, 6948},
    {3474, 6949, 6950},
    {3475, 6951, 6952},
    {3476, 6953, 6954},
    {3477, 6955, 6956},
    {3478, 6957, 6958},
    {3479, 6959, 6960},
    {3480, 6961, 6962},
    {3481, 6963, 6964},
    {3482, 6965, 6966},
    {3483, 6967, 6968},
    {3484, 6969, 6970},
    {3485, 6971, 6972},
    {3486, 6973, 6974},
    {3487, 6975, 6976},
    {3488, 6977, 6978},
    {3489, 6979, 6980},
    {3490, 6981, 6982},
    {3491, 6983, 6984},
    {3492, 6985, 6986},
    {3493, 6987, 6988},
    {3494, 6989, 6990},
    {3495, 6991, 6992},
    {3496, 6993, 6994},
    {3497, 6995, 6996},
    {3498, 6997, 6998},
    {3499, 6999, 7000},
    {3500, 7001, 7002},
    {3501, 7003, 7004},
    {3502, 7005, 7006},
    {3503, 7007, 7008},
    {3504, 7009, 7010},
    {3505, 7011, 7012},
    {3506, 7013, 7014},
    {3507, 7015, 7016},
    {3508, 7017, 7018},
    {3509, 7019, 7020},
    {3510, 7021, 7022},
    {3511, 7023, 7024},
    {3512, 7025, 7026},
    {3513, 7027, 7028},
    {3514, 7029, 7030},
    {3515, 7031, 7032},
    {3516, 7033, 7034},
    {3517, 7035, 7036},
    {3518, 7037, 7038},
    {3519, 7039, 7040},
    {3520, 7041, 7042}, // ########################################
    {3521, 7043, 7044},
    {3522, 7045, 7046},
    {3523, 7047, 7048},
    {3524, 7049, 7050},
    {3525, 7051, 7052},
    {3526, 7053, 7054},
    {3527, 7055, 7056},
    {3528, 7057, 7058},
    {3529, 7059, 7060},
    {3530, 7061, 7062},
    {3531, 7063, 7064},
    {3532, 7065, 7066},
    {3533, 7067, 7068},
    {3534, 7069, 7070},
    {3535, 7071, 7072},
    {3536, 7073, 7074},
    {3537, 7075, 7076},
    {3538, 7077, 7078},
    {3539, 7079, 7080},
    {3540, 7081, 7082},
    {3541, 7083, 7084},
    {3542, 7085, 7086},
    {3543, 7087, 7088},
    {3544, 7089, 7090},
    {3545, 7091, 7092},
    {3546, 7093, 7094},
    {3547, 7095, 7096},
    {3548, 7097, 7098},
    {3549, 7099, 7100},
    {3550, 7101, 7102},
    {3551, 7103, 7104},
    {3552, 7105, 7106},
    {3553, 7107, 7108},
    {3554, 7109, 7110},
    {3555, 7111, 7112},
    {3556, 7113, 7114},
    {3557, 7115, 7116},
    {3558, 7117, 7118},
    {3559, 7119, 7120},
    {3560, 7121, 7122},
    {3561, 7123, 7124},
    {3562, 7125, 7126},
    {3563, 7127, 7128},
    {3564, 7129, 7130},
    {3565, 7131, 7132},
    {3566, 7133, 7134},
    {3567, 7135, 7136},
    {3568, 7137, 7138},
    {3569, 7139, 7140},
    {3570, 7141, 7142},
    {3571, 7143, 7144},
    {3572, 7145, 7146},
    {3573, 7147, 7148},
    {3574, 7149, 7150},
    {3575, 7151, 7152},
    {3576, 7153, 7154},
    {3577, 7155, 7156},
    {3578, 7157, 7158},
    {3579, 7159, 7160},
    {3580, 7161, 7162},
    {3581, 7163, 7164},
    {3582, 7165, 7166},
    {3583, 7167, 7168},
    {3584, 7169, 7170}, // ########################################
    {3585, 7171, 7172},
    {3586, 7173, 7174},
    {3587, 7175, 7176},
    {3588, 7177, 7178},
    {3589, 7179, 7180},
    {3590, 7181, 7182},
    {3591, 7183, 7184},
    {3592, 7185, 7186},
    {3593, 7187, 7188},
    {3594, 7189, 7190},
    {3595, 7191, 7192},
    {3596, 7193, 7194},
    {3597, 7195, 7196},
    {3598, 7197, 7198},
    {3599, 7199, 7200},
    {3600, 7201, 7202},
    {3601, 7203, 7204},
    {3602, 7205, 7206},
    {3603, 7207, 7208},
    {3604, 7209, 7210},
    {3605, 7211, 7212},
    {3606, 7213, 7214},
    {3607, 7215, 7216},
    {3608, 7217, 7218},
    {3609, 7219, 7220},
    {3610, 7221, 7222},
    {3611, 7223, 7224},
    {3612, 7225, 7226},
    {3613, 7227, 7228},
    {3614, 7229, 7230},
    {3615, 7231, 7232},
    {3616, 7233, 7234},
    {3617, 7235, 7236},
    {3618, 7237, 7238},
    {3619, 7239, 7240},
    {3620, 7241, 7242},
    {3621, 7243, 7244},
    {3622, 7245, 7246},
    {3623, 7247, 7248},
    {3624, 7249, 7250},
    {3625, 7251, 7252},
    {3626, 7253, 7254},
    {3627, 7255, 7256},
    {3628, 7257, 7258},
    {3629, 7259, 7260},
    {3630, 7261, 7262},
    {3631, 7263, 7264},
    {3632, 7265, 7266},
    {3633, 7267, 7268},
    {3634, 7269, 7270},
    {3635, 7271, 7272},
    {3636, 7273, 7274},
    {3637, 7275, 7276},
    {3638, 7277, 7278},
    {3639, 7279, 7280},
    {3640, 7281, 7282},
    {3641, 7283, 7284},
    {3642, 7285, 7286},
    {3643, 7287, 7288},
    {3644, 7289, 7290},
    {3645, 7291, 7292},
    {3646, 7293, 7294},
    {3647, 7295, 7296},
    {3648, 7297, 7298}, // ########################################
    {3649, 7299, 7300},
    {3650, 7301, 7302},
    {3651, 7303, 7304},
    {3652, 7305, 7306},
    {3653, 7307, 7308},
    {3654, 7309, 7310},
    {3655, 7311, 7312},
    {3656, 7313, 7314},
    {3657, 7315, 7316},
    {3658, 7317, 7318},
    {3659, 7319, 7320},
    {3660, 7321, 7322},
    {3661, 7323, 7324},
    {3662, 7325, 7326},
    {3663, 7327, 7328},
    {3664, 7329, 7330},
    {3665, 7331, 7332},
    {3666, 7333, 7334},
    {3667, 7335, 7336},
    {3668, 7337, 7338},
    {3669, 7339, 7340},
    {3670, 7341, 7342},
    {3671, 7343, 7344},
    {3672, 7345, 7346},
    {3673, 7347, 7348},
    {3674, 7349, 7350},
    {3675, 7351, 7352},
    {3676, 7353, 7354},
    {3677, 7355, 7356},
    {3678, 7357, 7358},
    {3679, 7359, 7360},
    {3680, 7361, 7362},
    {3681, 7363, 7364},
    {3682, 7365, 7366},
    {3683, 7367, 7368},
    {3684, 7369, 7370},
    {3685, 7371, 7372},
    {3686, 7373, 7374},
    {3687, 7375, 7376},
    {3688, 7377, 7378},
    {3689, 7379, 7380},
    {3690, 7381, 7382},
    {3691, 7383, 7384},
    {3692, 7385, 7386},
    {3693, 7387, 7388},
    {3694, 7389, 7390},
    {3695, 7391, 7392},
    {3696, 7393, 7394},
    {3697, 7395, 7396},
    {3698, 7397, 7398},
    {3699, 7399, 7400},
    {3700, 7401, 7402},
    {3701, 7403, 7404},
    {3702, 7405, 7406},
    {3703, 7407, 7408},
    {3704, 7409, 7410},
    {3705, 7411, 7412},
    {3706, 7413, 7414},
    {3707, 7415, 7416},
    {3708, 7417, 7418},
    {3709, 7419, 7420},
    {3710, 7421, 7422},
    {3711, 7423, 7424},
    {3712, 7425, 7426}, // ########################################
    {3713, 7427, 7428},
    {3714, 7429, 7430},
    {3715, 7431, 7432},
    {3716, 7433, 7434},
    {3717, 7435, 7436},
    {3718, 7437, 7438},
    {3719, 7439, 7440},
    {3720, 7441, 7442},
    {3721, 7443, 7444},
    {3722, 7445, 7446},
    {3723, 7447, 7448},
    {3724, 7449, 7450},
    {3725, 7451, 7452},
    {3726, 7453, 7454},
    {3727, 7455, 7456},
    {3728, 7457, 7458},
    {3729, 7459, 7460},
    {3730, 7461, 7462},
    {3731, 7463, 7464},
    {3732, 7465, 7466},
    {3733, 7467, 7468},
    {3734, 7469, 7470},
    {3735, 7471, 7472},
    {3736, 7473, 7474},
    {3737, 7475, 7476},
    {3738, 7477, 7478},
    {3739, 7479, 7480},
    {3740, 7481, 7482},
    {3741, 7483, 7484},
    {3742, 7485, 7486},
    {3743, 7487, 7488},
    {3744, 7489, 7490},
    {3745, 7491, 7492},
    {3746, 7493, 7494},
    {3747, 7495, 7496},
    {3748, 7497, 7498},
    {3749, 7499, 7500},
    {3750, 7501, 7502},
    {3751, 7503, 7504},
    {3752, 7505, 7506},
    {3753, 7507, 7508},
    {3754, 7509, 7510},
    {3755, 7511, 7512},
    {3756, 7513, 7514},
    {3757, 7515, 7516},
    {3758, 7517, 7518},
    {3759, 7519, 7520},
    {3760, 7521, 7522},
    {3761, 7523, 7524},
    {3762, 7525, 7526},
    {3763, 7527, 7528},
    {3764, 7529, 7530},
    {3765, 7531, 7532},
    {3766, 7533, 7534},
    {3767, 7535, 7536},
    {3768, 7537, 7538},
    {3769, 7539, 7540},
    {3770, 7541, 7542},
    {3771, 7543, 7544},
    {3772, 7545, 7546},
    {3773, 7547, 7548},
    {3774, 7549, 7550},
    {3775, 7551, 7552},
    {3776, 7553, 7554}, // ########################################
    {3777, 7555, 7556},
    {3778, 7557, 7558},
    {3779, 7559, 7560},
    {3780, 7561, 7562},
    {3781, 7563, 7564},
    {3782, 7565, 7566},
    {3783, 7567, 7568},
    {3784, 7569, 7570},
    {3785, 7571, 7572},
    {3786, 7573, 7574},
    {3787, 7575, 7576},
    {3788, 7577, 7578},
    {3789, 7579, 7580},
    {3790, 7581, 7582},
    {3791, 7583, 7584},
    {3792, 7585, 7586},
    {3793, 7587, 7588},
    {3794, 7589, 7590},
    {3795, 7591, 7592},
    {3796, 7593, 7594},
    {3797, 7595, 7596},
    {3798, 7597, 7598},
    {3799, 7599, 7600},
    {3800, 7601, 7602},
    {3801, 7603, 7604},
    {3802, 7605, 7606},
    {3803, 7607, 7608},
    {3804, 7609, 7610},
    {3805, 7611, 7612},
    {3806, 7613, 7614},
    {3807, 7615, 7616},
    {3808, 7617, 7618},
    {3809, 7619, 7620},
    {3810, 7621, 7622},
    {3811, 7623, 7624},
    {3812, 7625, 7626},
    {3813, 7627, 7628},
    {3814, 7629, 7630},
    {3815, 7631, 7632},
    {3816, 7633, 7634},
    {3817, 7635, 7636},
    {3818, 7637, 7638},
    {3819, 7639, 7640},
    {3820, 7641, 7642},
    {3821, 7643, 7644},
    {3822, 7645, 7646},
    {3823, 7647, 7648},
    {3824, 7649, 7650},
    {3825, 7651, 7652},
    {3826, 7653, 7654},
    {3827, 7655, 7656},
    {3828, 7657, 7658},
    {3829, 7659, 7660},
    {3830, 7661, 7662},
    {3831, 7663, 7664},
    {3832, 7665, 7666},
    {3833, 7667, 7668},
    {3834, 7669, 7670},
    {3835, 7671, 7672},
    {3836, 7673, 7674},
    {3837, 7675, 7676},
    {3838, 7677, 7678},
    {3839, 7679, 7680},
    {3840, 7681, 7682}, // ########################################
    {3841, 7683, 7684},
    {3842, 7685, 7686},
    {3843, 7687, 7688},
    {3844, 7689, 7690},
    {3845, 7691, 7692},
    {3846, 7693, 7694},
    {3847, 7695, 7696},
    {3848, 7697, 7698},
    {3849, 7699, 7700},
    {3850, 7701, 7702},
    {3851, 7703, 7704},
    {3852, 7705, 7706},
    {3853, 7707, 7708},
    {3854, 7709, 7710},
    {3855, 7711, 7712},
    {3856, 7713, 7714},
    {3857, 7715, 7716},
    {3858, 7717, 7718},
    {3859, 7719, 7720},
    {3860, 7721, 7722},
    {3861, 7723, 7724},
    {3862, 7725, 7726},
    {3863, 7727, 7728},
    {3864, 7729, 7730},
    {3865, 7731, 7732},
    {3866, 7733, 7734},
    {3867, 7735, 7736},
    {3868, 7737, 7738},
    {3869, 7739, 7740},
    {3870, 7741, 7742},
    {3871, 7743, 7744},
    {3872, 7745, 7746},
    {3873, 7747, 7748},
    {3874, 7749, 7750},
    {3875, 7751, 7752},
    {3876, 7753, 7754},
    {3877, 7755, 7756},
    {3878, 7757, 7758},
    {3879, 7759, 7760},
    {3880, 7761, 7762},
    {3881, 7763, 7764},
    {3882, 7765, 7766},
    {3883, 7767, 7768},
    {3884, 7769, 7770},
    {3885, 7771, 7772},
    {3886, 7773, 7774},
    {3887, 7775, 7776},
    {3888, 7777, 7778},
    {3889, 7779, 7780},
    {3890, 7781, 7782},
    {3891, 7783, 7784},
    {3892, 7785, 7786},
    {3893, 7787, 7788},
    {3894, 7789, 7790},
    {3895, 7791, 7792},
    {3896, 7793, 7794},
    {3897, 7795, 7796},
    {3898, 7797, 7798},
    {3899, 7799, 7800},
    {3900, 7801, 7802},
    {3901, 7803, 7804},
    {3902, 7805, 7806},
    {3903, 7807, 7808},
    {3904, 7809, 7810}, // ########################################
    {3905, 7811, 7812},
    {3906, 7813, 7814},
    {3907, 7815, 7816},
    {3908, 7817, 7818},
    {3909, 7819, 7820},
    {3910, 7821, 7822},
    {3911, 7823, 7824},
    {3912, 7825, 7826},
    {3913, 7827, 7828},
    {3914, 7829, 7830},
    {3915, 7831, 7832},
    {3916, 7833, 7834},
    {3917, 7835, 7836},
    {3918, 7837, 7838},
    {3919, 7839, 7840},
    {3920, 7841, 7842},
    {3921, 7843, 7844},
    {3922, 7845, 7846},
    {3923, 7847, 7848},
    {3924, 7849, 7850},
    {3925, 7851, 7852},
    {3926, 7853, 7854},
    {3927, 7855, 7856},
    {3928, 7857, 7858},
    {3929, 7859, 7860},
    {3930, 7861, 7862},
    {3931, 7863, 7864},
    {3932, 7865, 7866},
    {3933, 7867, 7868},
    {3934, 7869, 7870},
    {3935, 7871, 7872},
    {3936, 7873, 7874},
    {3937, 7875, 7876},
    {3938, 7877, 7878},
    {3939, 7879, 7880},
    {3940, 7881, 7882},
    {3941, 7883, 7884},
    {3942, 7885, 7886},
    {3943, 7887, 7888},
    {3944, 7889, 7890},
    {3945, 7891, 7892},
    {3946, 7893, 7894},
    {3947, 7895, 7896},
    {3948, 7897, 7898},
    {3949, 7899, 7900},
    {3950, 7901, 7902},
    {3951, 7903, 7904},
    {3952, 7905, 7906},
    {3953, 7907, 7908},
    {3954, 7909, 7910},
    {3955, 7911, 7912},
    {3956, 7913, 7914},
    {3957, 7915, 7916},
    {3958, 7917, 7918},
    {3959, 7919, 7920},
    {3960, 7921, 7922},
    {3961, 7923, 7924},
    {3962, 7925, 7926},
    {3963, 7927, 7928},
    {3964, 7929, 7930},
    {3965, 7931, 7932},
    {3966, 7933, 7934},
    {3967, 7935, 7936},
    {3968, 7937, 7938}, // ########################################
    {3969, 7939, 7940},
    {3970, 7941, 7942},
    {3971, 7943, 7944},
    {3972, 7945, 7946},
    {3973, 7947, 7948},
    {3974, 7949, 7950},
    {3975, 7951, 7952},
    {3976, 7953, 7954},
    {3977, 7955, 7956},
    {3978, 7957, 7958},
    {3979, 7959, 7960},
    {3980, 7961, 7962},
    {3981, 7963, 7964},
    {3982, 7965, 7966},
    {3983, 7967, 7968},
    {3984, 7969, 7970},
    {3985, 7971, 7972},
    {3986, 7973, 7974},
    {3987, 7975, 7976},
    {3988, 7977, 7978},
    {3989, 7979, 7980},
    {3990, 7981, 7982},
    {3991, 7983, 7984},
    {3992, 7985, 7986},
    {3993, 7987, 7988},
    {3994, 7989, 7990},
    {3995, 7991, 7992},
    {3996, 7993, 7994},
    {3997, 7995, 7996},
    {3998, 7997, 7998},
    {3999, 7999, 8000},
    {4000, 8001, 8002},
    {4001, 8003, 8004},
    {4002, 8005, 8006},
    {4003, 8007, 8008},
    {4004, 8009, 8010},
    {4005, 8011, 8012},
    {4006, 8013, 8014},
    {4007, 8015, 8016},
    {4008, 8017, 8018},
    {4009, 8019, 8020},
    {4010, 8021, 8022},
    {4011, 8023, 8024},
    {4012, 8025, 8026},
    {4013, 8027, 8028},
    {4014, 8029, 8030},
    {4015, 8031, 8032},
    {4016, 8033, 8034},
    {4017, 8035, 8036},
    {4018, 8037, 8038},
    {4019, 8039, 8040},
    {4020, 8041, 8042},
    {4021, 8043, 8044},
    {4022, 8045, 8046},
    {4023, 8047, 8048},
    {4024, 8049, 8050},
    {4025, 8051, 8052},
    {4026, 8053, 8054},
    {4027, 8055, 8056},
    {4028, 8057, 8058},
    {4029, 8059, 8060},
    {4030, 8061, 8062},
    {4031, 8063, 8064},
    {4032, 8065, 8066}, // ########################################
    {4033, 8067, 8068},
    {4034, 8069, 8070},
    {4035, 8071, 8072},
    {4036, 8073, 8074},
    {4037, 8075, 8076},
    {4038, 8077, 8078},
    {4039, 8079, 8080},
    {4040, 8081, 8082},
    {4041, 8083, 8084},
    {4042, 8085, 8086},
    {4043, 8087, 8088},
    {4044, 8089, 8090},
    {4045, 8091, 8092},
    {4046, 8093, 8094},
    {4047, 8095, 8096},
    {4048, 8097, 8098},
    {4049, 8099, 8100},
    {4050, 8101, 8102},
    {4051, 8103, 8104},
    {4052, 8105, 8106},
    {4053, 8107, 8108},
    {4054, 8109, 8110},
    {4055, 8111, 8112},
    {4056, 8113, 8114},
    {4057, 8115, 8116},
    {4058, 8117, 8118},
    {4059, 8119, 8120},
    {4060, 8121, 8122},
    {4061, 8123, 8124},
    {4062, 8125, 8126},
    {4063, 8127, 8128},
    {4064, 8129, 8130},
    {4065, 8131, 8132},
    {4066, 8133, 8134},
    {4067, 8135, 8136},
    {4068, 8137, 8138},
    {4069, 8139, 8140},
    {4070, 8141, 8142},
    {4071, 8143, 8144},
    {4072, 8145, 8146},
    {4073, 8147, 8148},
    {4074, 8149, 8150},
    {4075, 8151, 8152},
    {4076, 8153, 8154},
    {4077, 8155, 8156},
    {4078, 8157, 8158},
    {4079, 8159, 8160},
    {4080, 8161, 8162},
    {4081, 8163, 8164},
    {4082, 8165, 8166},
    {4083, 8167, 8168},
    {4084, 8169, 8170},
    {4085, 8171, 8172},
    {4086, 8173, 8174},
    {4087, 8175, 8176},
    {4088, 8177, 8178},
    {4089, 8179, 8180},
    {4090, 8181, 8182},
    {4091, 8183, 8184},
    {4092, 8185, 8186},
    {4093, 8187, 8188},
    {4094, 8189, 8190},
    {4095, 8191, 8192},
    {4096, 8193, 8194}, // ########################################
    {4097, 8195, 8196},
    {4098, 8197, 8198},
    {4099, 8199, 8200},
    {4100, 8201, 8202},
    {4101, 8203, 8204},
    {4102, 8205, 8206},
    {4103, 8207, 8208},
    {4104, 8209, 8210},
    {4105, 8211, 8212},
    {4106, 8213, 8214},
    {4107, 8215, 8216},
    {4108, 8217, 8218},
    {4109, 8219, 8220},
    {4110, 8221, 8222},
    {4111, 8223, 8224},
    {4112, 8225, 8226},
    {4113, 8227, 8228},
    {4114, 8229, 8230},
    {4115, 8231, 8232},
    {4116, 8233, 8234},
    {4117, 8235, 8236},
    {4118, 8237, 8238},
    {4119, 8239, 8240},
    {4120, 8241, 8242},
    {4121, 8243, 8244},
    {4122, 8245, 8246},
    {4123, 8247, 8248},
    {4124, 8249, 8250},
    {4125, 8251, 8252},
    {4126, 8253, 8254},
    {4127, 8255, 8256},
    {4128, 8257, 8258},
    {4129, 8259, 8260},
    {4130, 8261, 8262},
    {4131, 8263, 8264},
    {4132, 8265, 8266},
    {4133, 8267, 8268},
    {4134, 8269, 8270},
    {4135, 8271, 8272},
    {4136, 8273, 8274},
    {4137, 8275, 8276},
    {4138, 8277, 8278},
    {4139, 8279, 8280},
    {4140, 8281, 8282},
    {4141, 8283, 8284},
    {4142, 8285, 8286},
    {4143, 8287, 8288},
    {4144, 8289, 8290},
    {4145, 8291, 8292},
    {4146, 8293, 8294},
    {4147, 8295, 8296},
    {4148, 8297, 8298},
    {4149, 8299, 8300},
    {4150, 8301, 8302},
    {4151, 8303, 8304},
    {4152, 8305, 8306},
    {4153, 8307, 8308},
    {4154, 8309, 8310},
    {4155, 8311, 8312},
    {4156, 8313, 8314},
    {4157, 8315, 8316},
    {4158, 8317, 8318},
    {4159, 8319, 8320},
    {4160, 8321, 8322}, // ########################################
    {4161, 8323, 8324},
    {4162, 8325, 8326},
    {4163, 8327, 8328},
    {4164, 8329, 8330},
    {4165, 8331, 8332},
    {4166, 8333, 8334},
    {4167, 8335, 8336},
    {4168, 8337, 8338},
    {4169, 8339, 8340},
    {4170, 8341, 8342},
    {4171, 8343, 8344},
    {4172, 8345, 8346},
    {4173, 8347, 8348},
    {4174, 8349, 8350},
    {4175, 8351, 8352},
    {4176, 8353, 8354},
    {4177, 8355, 8356},
    {4178, 8357, 8358},
    {4179, 8359, 8360},
    {4180, 8361, 8362},
    {4181, 8363, 8364},
    {4182, 8365, 8366},
    {4183, 8367, 8368},
    {4184, 8369, 8370},
    {4185, 8371, 8372},
    {4186, 8373, 8374},
    {4187, 8375, 8376},
    {4188, 8377, 8378},
    {4189, 8379, 8380},
    {4190, 8381, 8382},
    {4191, 8383, 8384},
    {4192, 8385, 8386},
    {4193, 8387, 8388},
    {4194, 8389, 8390},
    {4195, 8391, 8392},
    {4196, 8393, 8394},
    {4197, 8395, 8396},
    {4198, 8397, 8398},
    {4199, 8399, 8400},
    {4200, 8401, 8402},
    {4201, 8403, 8404},
    {4202, 8405, 8406},
    {4203, 8407, 8408},
    {4204, 8409, 8410},
    {4205, 8411, 8412},
    {4206, 8413, 8414},
    {4207, 8415, 8416},
    {4208, 8417, 8418},
    {4209, 8419, 8420},
    {4210, 8421, 8422},
    {4211, 8423, 8424},
    {4212, 8425, 8426},
    {4213, 8427, 8428},
    {4214, 8429, 8430},
    {4215, 8431, 8432},
    {4216, 8433, 8434},
    {4217, 8435, 8436},
    {4218, 8437, 8438},
    {4219, 8439, 8440},
    {4220, 8441, 8442},
    {4221, 8443, 8444},
    {4222, 8445, 8446},
    {4223, 8447, 8448},
    {4224, 8449, 8450}, // ########################################
    {4225, 8451, 8452},
    {4226, 8453, 8454},
    {4227, 8455, 8456},
    {4228, 8457, 8458},
    {4229, 8459, 8460},
    {4230, 8461, 8462},
    {4231, 8463, 8464},
    {4232, 8465, 8466},
    {4233, 8467, 8468},
    {4234, 8469, 8470},
    {4235, 8471, 8472},
    {4236, 8473, 8474},
    {4237, 8475, 8476},
    {4238, 8477, 8478},
    {4239, 8479, 8480},
    {4240, 8481, 8482},
    {4241, 8483, 8484},
    {4242, 8485, 8486},
    {4243, 8487, 8488},
    {4244, 8489, 8490},
    {4245, 8491, 8492},
    {4246, 8493, 8494},
    {4247, 8495, 8496},
    {4248, 8497, 8498},
    {4249, 8499, 8500},
    {4250, 8501, 8502},
    {4251, 8503, 8504},
    {4252, 8505, 8506},
    {4253, 8507, 8508},
    {4254, 8509, 8510},
    {4255, 8511, 8512},
    {4256, 8513, 8514},
    {4257, 8515, 8516},
    {4258, 8517, 8518},
    {4259, 8519, 8520},
    {4260, 8521, 8522},
    {4261, 8523, 8524},
    {4262, 8525, 8526},
    {4263, 8527, 8528},
    {4264, 8529, 8530},
    {4265, 8531, 8532},
    {4266, 8533, 8534},
    {4267, 8535, 8536},
    {4268, 8537, 8538},
    {4269, 8539, 8540},
    {4270, 8541, 8542},
    {4271, 8543, 8544},
    {4272, 8545, 8546},
    {4273, 8547, 8548},
    {4274, 8549, 8550},
    {4275, 8551, 8552},
    {4276, 8553, 8554},
    {4277, 8555, 8556},
    {4278, 8557, 8558},
    {4279, 8559, 8560},
    {4280, 8561, 8562},
    {4281, 8563, 8564},
    {4282, 8565, 8566},
    {4283, 8567, 8568},
    {4284, 8569, 8570},
    {4285, 8571, 8572},
    {4286, 8573, 8574},
    {4287, 8575, 8576},
    {4288, 8577, 8578}, // ########################################
    {4289, 8579, 8580},
    {4290, 8581, 8582},
    {4291, 8583, 8584},
    {4292, 8585, 8586},
    {4293, 8587, 8588},
    {4294, 8589, 8590},
    {4295, 8591, 8592},
    {4296, 8593, 8594},
    {4297, 8595, 8596},
    {4298, 8597, 8598},
    {4299, 8599, 8600},
    {4300, 8601, 8602},
    {4301, 8603, 8604},
    {4302, 8605, 8606},
    {4303, 8607, 8608},
    {4304, 8609, 8610},
    {4305, 8611, 8612},
    {4306, 8613, 8614},
    {4307, 8615, 8616},
    {4308, 8617, 8618},
    {4309, 8619, 8620},
    {4310, 8621, 8622},
    {4311, 8623, 8624},
    {4312, 8625, 8626},
    {4313, 8627, 8628},
    {4314, 8629, 8630},
    {4315, 8631, 8632},
    {4316, 8633, 8634},
    {4317, 8635, 8636},
    {4318, 8637, 8638},
    {4319, 8639, 8640},
    {4320, 8641, 8642},
    {4321, 8643, 8644},
    {4322, 8645, 8646},
    {4323, 8647, 8648},
    {4324, 8649, 8650},
    {4325, 8651, 8652},
    {4326, 8653, 8654},
    {4327, 8655, 8656},
    {4328, 8657, 8658},
    {4329, 8659, 8660},
    {4330, 8661, 8662},
    {4331, 8663, 8664},
    {4332, 8665, 8666},
    {4333, 8667, 8668},
    {4334, 8669, 8670},
    {4335, 8671, 8672},
    {4336, 8673, 8674},
    {4337, 8675, 8676},
    {4338, 8677, 8678},
    {4339, 8679, 8680},
    {4340, 8681, 8682},
    {4341, 8683, 8684},
    {4342, 8685, 8686},
    {4343, 8687, 8688},
    {4344, 8689, 8690},
    {4345, 8691, 8692},
    {4346, 8693, 8694},
    {4347, 8695, 8696},
    {4348, 8697, 8698},
    {4349, 8699, 8700},
    {4350, 8701, 8702},
    {4351, 8703, 8704},
    {4352, 8705, 8706}, // ########################################
    {4353, 8707, 8708},
    {4354, 8709, 8710},
    {4355, 8711, 8712},
    {4356, 8713, 8714},
    {4357, 8715, 8716},
    {4358, 8717, 8718},
    {4359, 8719, 8720},
    {4360, 8721, 8722},
    {4361, 8723, 8724},
    {4362, 8725, 8726},
    {4363, 8727, 8728},
    {4364, 8729, 8730},
    {4365, 8731, 8732},
    {4366, 8733, 8734},
    {4367, 8735, 8736},
    {4368, 8737, 8738},
    {4369, 8739, 8740},
    {4370, 8741, 8742},
    {4371, 8743, 8744},
    {4372, 8745, 8746},
    {4373, 8747, 8748},
    {4374, 8749, 8750},
    {4375, 8751, 8752},
    {4376, 8753, 8754},
    {4377, 8755, 8756},
    {4378, 8757, 8758},
    {4379, 8759, 8760},
    {4380, 8761, 8762},
    {4381, 8763, 8764},
    {4382, 8765, 8766},
    {4383, 8767, 8768},
    {4384, 8769, 8770},
    {4385, 8771, 8772},
    {4386, 8773, 8774},
    {4387, 8775, 8776},
    {4388, 8777, 8778},
    {4389, 8779, 8780},
    {4390, 8781, 8782},
    {4391, 8783, 8784},
    {4392, 8785, 8786},
    {4393, 8787, 8788},
    {4394, 8789, 8790},
    {4395, 8791, 8792},
    {4396, 8793, 8794},
    {4397, 8795, 8796},
    {4398, 8797, 8798},
    {4399, 8799, 8800},
    {4400, 8801, 8802},
    {4401, 8803, 8804},
    {4402, 8805, 8806},
    {4403, 8807, 8808},
    {4404, 8809, 8810},
    {4405, 8811, 8812},
    {4406, 8813, 8814},
    {4407, 8815, 8816},
    {4408, 8817, 8818},
    {4409, 8819, 8820},
    {4410, 8821, 8822},
    {4411, 8823, 8824},
    {4412, 8825, 8826},
    {4413, 8827, 8828},
    {4414, 8829, 8830},
    {4415, 8831, 8832},
    {4416, 8833, 8834}, // ########################################
    {4417, 8835, 8836},
    {4418, 8837, 8838},
    {4419, 8839, 8840},
    {4420, 8841, 8842},
    {4421, 8843, 8844},
    {4422, 8845, 8846},
    {4423, 8847, 8848},
    {4424, 8849, 8850},
    {4425, 8851, 8852},
    {4426, 8853, 8854},
    {4427, 8855, 8856},
    {4428, 8857, 8858},
    {4429, 8859, 8860},
    {4430, 8861, 8862},
    {4431, 8863, 8864},
    {4432, 8865, 8866},
    {4433, 8867, 8868},
    {4434, 8869, 8870},
    {4435, 8871, 8872},
    {4436, 8873, 8874},
    {4437, 8875, 8876},
    {4438, 8877, 8878},
    {4439, 8879, 8880},
    {4440, 8881, 8882},
    {4441, 8883, 8884},
    {4442, 8885, 8886},
    {4443, 8887, 8888},
    {4444, 8889, 8890},
    {4445, 8891, 8892},
    {4446, 8893, 8894},
    {4447, 8895, 8896},
    {4448, 8897, 8898},
    {4449, 8899, 8900},
    {4450, 8901, 8902},
    {4451, 8903, 8904},
    {4452, 8905, 8906},
    {4453, 8907, 8908},
    {4454, 8909, 8910},
    {4455, 8911, 8912},
    {4456, 8913, 8914},
    {4457, 8915, 8916},
    {4458, 8917, 8918},
    {4459, 8919, 8920},
    {4460, 8921, 8922},
    {4461, 8923, 8924},
    {4462, 8925, 8926},
    {4463, 8927, 8928},
    {4464, 8929, 8930},
    {4465, 8931, 8932},
    {4466, 8933, 8934},
    {4467, 8935, 8936},
    {4468, 8937, 8938},
    {4469, 8939, 8940},
    {4470, 8941, 8942},
    {4471, 8943, 8944},
    {4472, 8945, 8946},
    {4473, 8947, 8948},
    {4474, 8949, 8950},
    {4475, 8951, 8952},
    {4476, 8953, 8954},
    {4477, 8955, 8956},
    {4478, 8957, 8958},
    {4479, 8959, 8960},
    {4480, 8961, 8962}, // ########################################
    {4481, 8963, 8964},
    {4482, 8965, 8966},
    {4483, 8967, 8968},
    {4484, 8969, 8970},
    {4485, 8971, 8972},
    {4486, 8973, 8974},
    {4487, 8975, 8976},
    {4488, 8977, 8978},
    {4489, 8979, 8980},
    {4490, 8981, 8982},
    {4491, 8983, 8984},
    {4492, 8985, 8986},
    {4493, 8987, 8988},
    {4494, 8989, 8990},
    {4495, 8991, 8992},
    {4496, 8993, 8994},
    {4497, 8995, 8996},
    {4498, 8997, 8998},
    {4499, 8999, 9000},
    {4500, 9001, 9002},
    {4501, 9003, 9004},
    {4502, 9005, 9006},
    {4503, 9007, 9008},
    {4504, 9009, 9010},
    {4505, 9011, 9012},
    {4506, 9013, 9014},
    {4507, 9015, 9016},
    {4508, 9017, 9018},
    {4509, 9019, 9020},
    {4510, 9021, 9022},
    {4511, 9023, 9024},
    {4512, 9025, 9026},
    {4513, 9027, 9028},
    {4514, 9029, 9030},
    {4515, 9031, 9032},
    {4516, 9033, 9034},
    {4517, 9035, 9036},
    {4518, 9037, 9038},
    {4519, 9039, 9040},
    {4520, 9041, 9042},
    {4521, 9043, 9044},
    {4522, 9045, 9046},
    {4523, 9047, 9048},
    {4524, 9049, 9050},
    {4525, 9051, 9052},
    {4526, 9053, 9054},
    {4527, 9055, 9056},
    {4528, 9057, 9058},
    {4529, 9059, 9060},
    {4530, 9061, 9062},
    {4531, 9063, 9064},
    {4532, 9065, 9066},
    {4533, 9067, 9068},
    {4534, 9069, 9070},
    {4535, 9071, 9072},
    {4536, 9073, 9074},
    {4537, 9075, 9076},
    {4538, 9077, 9078},
    {4539, 9079, 9080},
    {4540, 9081, 9082},
    {4541, 9083, 9084},
    {4542, 9085, 9086},
    {4543, 9087, 9088},
    {4544, 9089, 9090}, // ########################################
    {4545, 9091, 9092},
    {4546, 9093, 9094},
    {4547, 9095, 9096},
    {4548, 9097, 9098},
    {4549, 9099, 9100},
    {4550, 9101, 9102},
    {4551, 9103, 9104},
    {4552, 9105, 9106},
    {4553, 9107, 9108},
    {4554, 9109, 9110},
    {4555, 9111, 9112},
    {4556, 9113, 9114},
    {4557, 9115, 9116},
    {4558, 9117, 9118},
    {4559, 9119, 9120},
    {4560, 9121, 9122},
    {4561, 9123, 9124},
    {4562, 9125, 9126},
    {4563, 9127, 9128},
    {4564, 9129, 9130},
    {4565, 9131, 9132},
    {4566, 9133, 9134},
    {4567, 9135, 9136},
    {4568, 9137, 9138},
    {4569, 9139, 9140},
    {4570, 9141, 9142},
    {4571, 9143, 9144},
    {4572, 9145, 9146},
    {4573, 9147, 9148},
    {4574, 9149, 9150},
    {4575, 9151, 9152},
    {4576, 9153, 9154},
    {4577, 9155, 9156},
    {4578, 9157, 9158},
    {4579, 9159, 9160},
    {4580, 9161, 9162},
    {4581, 9163, 9164},
    {4582, 9165, 9166},
    {4583, 9167, 9168},
    {4584, 9169, 9170},
    {4585, 9171, 9172},
    {4586, 9173, 9174},
    {4587, 9175, 9176},
    {4588, 9177, 9178},
    {4589, 9179, 9180},
    {4590, 9181, 9182},
    {4591, 9183, 9184},
    {4592, 9185, 9186},
    {4593, 9187, 9188},
    {4594, 9189, 9190},
    {4595, 9191, 9192},
    {4596, 9193, 9194},
    {4597, 9195, 9196},
    {4598, 9197, 9198},
    {4599, 9199, 9200},
    {4600, 9201, 9202},
    {4601, 9203, 9204},
    {4602, 9205, 9206},
    {4603, 9207, 9208},
    {4604, 9209, 9210},
    {4605, 9211, 9212},
    {4606, 9213, 9214},
    {4607, 9215, 9216},
    {4608, 9217, 9218}, // ########################################
    {4609, 9219, 9220},
    {4610, 9221, 9222},
    {4611, 9223, 9224},
    {4612, 9225, 9226},
    {4613, 9227, 9228},
    {4614, 9229, 9230},
    {4615, 9231, 9232},
    {4616, 9233, 9234},
    {4617, 9235, 9236},
    {4618, 9237, 9238},
    {4619, 9239, 9240},
    {4620, 9241, 9242},
    {4621, 9243, 9244},
    {4622, 9245, 9246},
    {4623, 9247, 9248},
    {4624, 9249, 9250},
    {4625, 9251, 9252},
    {4626, 9253, 9254},
    {4627, 9255, 9256},
    {4628, 9257, 9258},
    {4629, 9259, 9260},
    {4630, 9261, 9262},
    {4631, 9263, 9264},
    {4632, 9265, 9266},
    {4633, 9267, 9268},
    {4634, 9269, 9270},
    {4635, 9271, 9272},
    {4636, 9273, 9274},
    {4637, 9275, 9276},
    {4638, 9277, 9278},
    {4639, 9279, 9280},
    {4640, 9281, 9282},
    {4641, 9283, 9284},
    {4642, 9285, 9286},
    {4643, 9287, 9288},
    {4644, 9289, 9290},
    {4645, 9291, 9292},
    {4646, 9293, 9294},
    {4647, 9295, 9296},
    {4648, 9297, 9298},
    {4649, 9299, 9300},
    {4650, 9301, 9302},
    {4651, 9303, 9304},
    {4652, 9305, 9306},
    {4653, 9307, 9308},
    {4654, 9309, 9310},
    {4655, 9311, 9312},
    {4656, 9313, 9314},
    {4657, 9315, 9316},
    {4658, 9317, 9318},
    {4659, 9319, 9320},
    {4660, 9321, 9322},
    {4661, 9323, 9324},
    {4662, 9325, 9326},
    {4663, 9327, 9328},
    {4664, 9329, 9330},
    {4665, 9331, 9332},
    {4666, 9333, 9334},
    {4667, 9335, 9336},
    {4668, 9337, 9338},
    {4669, 9339, 9340},
    {4670, 9341, 9342},
    {4671, 9343, 9344},
    {4672, 9345, 9346}, // ########################################
    {4673, 9347, 9348},
    {4674, 9349, 9350},
    {4675, 9351, 9352},
    {4676, 9353, 9354},
    {4677, 9355, 9356},
    {4678, 9357, 9358},
    {4679, 9359, 9360},
    {4680, 9361, 9362},
    {4681, 9363, 9364},
    {4682, 9365, 9366},
    {4683, 9367, 9368},
    {4684, 9369, 9370},
    {4685, 9371, 9372},
    {4686, 9373, 9374},
    {4687, 9375, 9376},
    {4688, 9377, 9378},
    {4689, 9379, 9380},
    {4690, 9381, 9382},
    {4691, 9383, 9384},
    {4692, 9385, 9386},
    {4693, 9387, 9388},
    {4694, 9389, 9390},
    {4695, 9391, 9392},
    {4696, 9393, 9394},
    {4697, 9395, 9396},
    {4698, 9397, 9398},
    {4699, 9399, 9400},
    {4700, 9401, 9402},
    {4701, 9403, 9404},
    {4702, 9405, 9406},
    {4703, 9407, 9408},
    {4704, 9409, 9410},
    {4705, 9411, 9412},
    {4706, 9413, 9414},
    {4707, 9415, 9416},
    {4708, 9417, 9418},
    {4709, 9419, 9420},
    {4710, 9421, 9422},
    {4711, 9423, 9424},
    {4712, 9425, 9426},
    {4713, 9427, 9428},
    {4714, 9429, 9430},
    {4715, 9431, 9432},
    {4716, 9433, 9434},
    {4717, 9435, 9436},
    {4718, 9437, 9438},
    {4719, 9439, 9440},
    {4720, 9441, 9442},
    {4721, 9443, 9444},
    {4722, 9445, 9446},
    {4723, 9447, 9448},
    {4724, 9449, 9450},
    {4725, 9451, 9452},
    {4726, 9453, 9454},
    {4727, 9455, 9456},
    {4728, 9457, 9458},
    {4729, 9459, 9460},
    {4730, 9461, 9462},
    {4731, 9463, 9464},
    {4732, 9465, 9466},
    {4733, 9467, 9468},
    {4734, 9469, 9470},
    {4735, 9471, 9472},
    {4736, 9473, 9474}, // ########################################
    {4737, 9475, 9476},
    {4738, 9477, 9478},
    {4739, 9479, 9480},
    {4740, 9481, 9482},
    {4741, 9483, 9484},
    {4742, 9485, 9486},
    {4743, 9487, 9488},
    {4744, 9489, 9490},
    {4745, 9491, 9492},
    {4746, 9493, 9494},
    {4747, 9495, 9496},
    {4748, 9497, 9498},
    {4749, 9499, 9500},
    {4750, 9501, 9502},
    {4751, 9503, 9504},
    {4752, 9505, 9506},
    {4753, 9507, 9508},
    {4754, 9509, 9510},
    {4755, 9511, 9512},
    {4756, 9513, 9514},
    {4757, 9515, 9516},
    {4758, 9517, 9518},
    {4759, 9519, 9520},
    {4760, 9521, 9522},
    {4761, 9523, 9524},
    {4762, 9525, 9526},
    {4763, 9527, 9528},
    {4764, 9529, 9530},
    {4765, 9531, 9532},
    {4766, 9533, 9534},
    {4767, 9535, 9536},
    {4768, 9537, 9538},
    {4769, 9539, 9540},
    {4770, 9541, 9542},
    {4771, 9543, 9544},
    {4772, 9545, 9546},
    {4773, 9547, 9548},
    {4774, 9549, 9550},
    {4775, 9551, 9552},
    {4776, 9553, 9554},
    {4777, 9555, 9556},
    {4778, 9557, 9558},
    {4779, 9559, 9560},
    {4780, 9561, 9562},
    {4781, 9563, 9564},
    {4782, 9565, 9566},
    {4783, 9567, 9568},
    {4784, 9569, 9570},
    {4785, 9571, 9572},
    {4786, 9573, 9574},
    {4787, 9575, 9576},
    {4788, 9577, 9578},
    {4789, 9579, 9580},
    {4790, 9581, 9582},
    {4791, 9583, 9584},
    {4792, 9585, 9586},
    {4793, 9587, 9588},
    {4794, 9589, 9590},
    {4795, 9591, 9592},
    {4796, 9593, 9594},
    {4797, 9595, 9596},
    {4798, 9597, 9598},
    {4799, 9599, 9600},
    {4800, 9601, 9602}, // ########################################
    {4801, 9603, 9604},
    {4802, 9605, 9606},
    {4803, 9607, 9608},
    {4804, 9609, 9610},
    {4805, 9611, 9612},
    {4806, 9613, 9614},
    {4807, 9615, 9616},
    {4808, 9617, 9618},
    {4809, 9619, 9620},
    {4810, 9621, 9622},
    {4811, 9623, 9624},
    {4812, 9625, 9626},
    {4813, 9627, 9628},
    {4814, 9629, 9630},
    {4815, 9631, 9632},
    {4816, 9633, 9634},
    {4817, 9635, 9636},
    {4818, 9637, 9638},
    {4819, 9639, 9640},
    {4820, 9641, 9642},
    {4821, 9643, 9644},
    {4822, 9645, 9646},
    {4823, 9647, 9648},
    {4824, 9649, 9650},
    {4825, 9651, 9652},
    {4826, 9653, 9654},
    {4827, 9655, 9656},
    {4828, 9657, 9658},
    {4829, 9659, 9660},
    {4830, 9661, 9662},
    {4831, 9663, 9664},
    {4832, 9665, 9666},
    {4833, 9667, 9668},
    {4834, 9669, 9670},
    {4835, 9671, 9672},
    {4836, 9673, 9674},
    {4837, 9675, 9676},
    {4838, 9677, 9678},
    {4839, 9679, 9680},
    {4840, 9681, 9682},
    {4841, 9683, 9684},
    {4842, 9685, 9686},
    {4843, 9687, 9688},
    {4844, 9689, 9690},
    {4845, 9691, 9692},
    {4846, 9693, 9694},
    {4847, 9695, 9696},
    {4848, 9697, 9698},
    {4849, 9699, 9700},
    {4850, 9701, 9702},
    {4851, 9703, 9704},
    {4852, 9705, 9706},
    {4853, 9707, 9708},
    {4854, 9709, 9710},
    {4855, 9711, 9712},
    {4856, 9713, 9714},
    {4857, 9715, 9716},
    {4858, 9717, 9718},
    {4859, 9719, 9720},
    {4860, 9721, 9722},
    {4861, 9723, 9724},
    {4862, 9725, 9726},
    {4863, 9727, 9728},
    {4864, 9729, 9730}, // ########################################
    {4865, 9731, 9732},
    {4866, 9733, 9734},
    {4867, 9735, 9736},
    {4868, 9737, 9738},
    {4869, 9739, 9740},
    {4870, 9741, 9742},
    {4871, 9743, 9744},
    {4872, 9745, 9746},
    {4873, 9747, 9748},
    {4874, 9749, 9750},
    {4875, 9751, 9752},
    {4876, 9753, 9754},
    {4877, 9755, 9756},
    {4878, 9757, 9758},
    {4879, 9759, 9760},
    {4880, 9761, 9762},
    {4881, 9763, 9764},
    {4882, 9765, 9766},
    {4883, 9767, 9768},
    {4884, 9769, 9770},
    {4885, 9771, 9772},
    {4886, 9773, 9774},
    {4887, 9775, 9776},
    {4888, 9777, 9778},
    {4889, 9779, 9780},
    {4890, 9781, 9782},
    {4891, 9783, 9784},
    {4892, 9785, 9786},
    {4893, 9787, 9788},
    {4894, 9789, 9790},
    {4895, 9791, 9792},
    {4896, 9793, 9794},
    {4897, 9795, 9796},
    {4898, 9797, 9798},
    {4899, 9799, 9800},
    {4900, 9801, 9802},
    {4901, 9803, 9804},
    {4902, 9805, 9806},
    {4903, 9807, 9808},
    {4904, 9809, 9810},
    {4905, 9811, 9812},
    {4906, 9813, 9814},
    {4907, 9815, 9816},
    {4908, 9817, 9818},
    {4909, 9819, 9820},
    {4910, 9821, 9822},
    {4911, 9823, 9824},
    {4912, 9825, 9826},
    {4913, 9827, 9828},
    {4914, 9829, 9830},
    {4915, 9831, 9832},
    {4916, 9833, 9834},
    {4917, 9835, 9836},
    {4918, 9837, 9838},
    {4919, 9839, 9840},
    {4920, 9841, 9842},
    {4921, 9843, 9844},
    {4922, 9845, 9846},
    {4923, 9847, 9848},
    {4924, 9849, 9850},
    {4925, 9851, 9852},
    {4926, 9853, 9854},
    {4927, 9855, 9856},
    {4928, 9857, 9858}, // ########################################
    {4929, 9859, 9860},
    {4930, 9861, 9862},
    {4931, 9863, 9864},
    {4932, 9865, 9866},
    {4933, 9867, 9868},
    {4934, 9869, 9870},
    {4935, 9871, 9872},
    {4936, 9873, 9874},
    {4937, 9875, 9876},
    {4938, 9877, 9878},
    {4939, 9879, 9880},
    {4940, 9881, 9882},
    {4941, 9883, 9884},
    {4942, 9885, 9886},
    {4943, 9887, 9888},
    {4944, 9889, 9890},
    {4945, 9891, 9892},
    {4946, 9893, 9894},
    {4947, 9895, 9896},
    {4948, 9897, 9898},
    {4949, 9899, 9900},
    {4950, 9901, 9902},
    {4951, 9903, 9904},
    {4952, 9905, 9906},
    {4953, 9907, 9908},
    {4954, 9909, 9910},
    {4955, 9911, 9912},
    {4956, 9913, 9914},
    {4957, 9915, 9916},
    {4958, 9917, 9918},
    {4959, 9919, 9920},
    {4960, 9921, 9922},
    {4961, 9923, 9924},
    {4962, 9925, 9926},
    {4963, 9927, 9928},
    {4964, 9929, 9930},
    {4965, 9931, 9932},
    {4966, 9933, 9934},
    {4967, 9935, 9936},
    {4968, 9937, 9938},
    {4969, 9939, 9940},
    {4970, 9941, 9942},
    {4971, 9943, 9944},
    {4972, 9945, 9946},
    {4973, 9947, 9948},
    {4974, 9949, 9950},
    {4975, 9951, 9952},
    {4976, 9953, 9954},
    {4977, 9955, 9956},
    {4978, 9957, 9958},
    {4979, 9959, 9960},
    {4980, 9961, 9962},
    {4981, 9963, 9964},
    {4982, 9965, 9966},
    {4983, 9967, 9968},
    {4984, 9969, 9970},
    {4985, 9971, 9972},
    {4986, 9973, 9974},
    {4987, 9975, 9976},
    {4988, 9977, 9978},
    {4989, 9979, 9980},
    {4990, 9981, 9982},
    {4991, 9983, 9984},
    {4992, 9985, 9986}, // ########################################
    {4993, 9987, 9988},
    {4994, 9989, 9990},
    {4995, 9991, 9992},
    {4996, 9993, 9994},
    {4997, 9995, 9996},
    {4998, 9997, 9998},
    {4999, 9999, 10000},
};

void BVH::construct(const Mesh& mesh) {
    const auto numFaces = static_cast<uint32_t>(mesh.getFaces().size());
    faceIndices.resize(numFaces);
    std::iota(faceIndices.begin(), faceIndices.end(), 0u);
    nodes.assign(1, Node{mesh.getBounds(), 0, numFaces});
    const std::vector<Point3D> centres = centresOf(mesh);
    for (size_t i = 0; i < nodes.size() && std::bit_width(i + 1) <= maxDepth; ++i) {
        const Node node = nodes[i];
        if (node.facesEnd - node.facesBegin <= numFacesPerLeaf)
            continue;
        const uint32_t middle = node.facesBegin + (node.facesEnd - node.facesBegin) / 2;
        const size_t axis = node.bounds.extents().maxDimension();
        std::nth_element(faceIndices.begin() + node.facesBegin, faceIndices.begin() + middle, faceIndices.begin() + node.facesEnd,
                         [&](uint32_t a, uint32_t b) { return centres[a][axis] < centres[b][axis]; });
        if (nodes.size() < 2 * i + 3)
            nodes.resize((i < std::size(families) ? size_t{families[i].right} : 2 * i + 2) + 1);
        const std::span<const uint32_t> all(faceIndices);
        nodes[2 * i + 1] = {boxOf(mesh, all.subspan(node.facesBegin, middle - node.facesBegin)), node.facesBegin, middle};
        nodes[2 * i + 2] = {boxOf(mesh, all.subspan(middle, node.facesEnd - middle)), middle, node.facesEnd};
    }
}

Intersection intersect(const Mesh& mesh, const IntersectionRay& ray) {
    const std::vector<BVH::Node>& nodes = mesh.getBVH().getNodes();
    Intersection closest;
    IntersectionRay rest(ray);
    std::vector<size_t> open;
    if (!nodes.empty())
        open.push_back(0);
    while (!open.empty()) {
        const size_t i = open.back();
        open.pop_back();
        if (!intersect(nodes[i].bounds, rest))
            continue;
        if (2 * i + 2 < nodes.size() && nodes[2 * i + 1].facesEnd != 0) {
            open.push_back(2 * i + 2);
            open.push_back(2 * i + 1);
            continue;
        }
        for (const uint32_t face : mesh.getBVH().getFaceIndices(nodes[i])) {
            const Intersection hit = intersect(mesh.getTriangleFromFaceIndex(face), rest);
            if (hit) {
                closest = hit;
                rest.t_max = hit.t;
            }
        }
    }
    return closest;
}
